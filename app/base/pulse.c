/* SPDX-License-Identifier: MIT */
/* Watching the main loop from its poll function, which sees every moment at which it is idle. */
#include "pulse.h"

#include <stdio.h>
#include <time.h>

#include "../../front/words.h"

enum {
    START_MICROSECONDS = 500000,
    BINS = 100000,
    BIN_MICROSECONDS = 10
}; /* up to a second; the last one takes the rest */

/* What is counted: of everything, and of the time since the last line. */
typedef struct Count {
    guint64 bins[BINS];
    guint64 turns;
    gint64 longest;
    guint64 pictures, frames;
    gint64 since;
    double loop_seconds, all_seconds; /* that the main loop and the whole program had worked by then */
} Count;

/* There is one main loop. */
static struct {
    gboolean is_on;
    GPollFunc poll;
    gint64 woken, begun;
    gint64 first;         /* when the first picture came, */
    double first_seconds; /* and how long processors had worked for the program by then */
    gboolean is_settled;
    Count all, recent;
} pulse;

static void add(Count *count, gint64 away)
{
    gint64 bin = away / BIN_MICROSECONDS;
    count->bins[CLAMP(bin, 0, BINS - 1)]++;
    count->turns++;
    count->longest = MAX(count->longest, away);
}

static double seconds_of(clockid_t clock)
{
    struct timespec work = {.tv_sec = 0};
    clock_gettime(clock, &work);
    return (double)work.tv_sec + 1e-9 * (double)work.tv_nsec;
}

/* Building the window is over; what counts from here on is how it answers. */
static void settle(void)
{
    pulse.is_settled = TRUE;
    pulse.all = (Count){.since = g_get_monotonic_time(),
                        .loop_seconds = seconds_of(CLOCK_THREAD_CPUTIME_ID),
                        .all_seconds = seconds_of(CLOCK_PROCESS_CPUTIME_ID)};
    pulse.recent = (Count){.since = pulse.all.since};
}

static int watched_poll(GPollFD *files, guint count, int timeout)
{
    const gint64 away = g_get_monotonic_time() - pulse.woken;
    if (!pulse.is_settled && pulse.first && g_get_monotonic_time() - pulse.first > START_MICROSECONDS)
        settle();
    else if (pulse.woken) {
        add(&pulse.all, away);
        add(&pulse.recent, away);
    }
    int result = pulse.poll(files, count, timeout);
    pulse.woken = g_get_monotonic_time();
    return result;
}

void app_pulse_start(void)
{
    pulse.is_on = TRUE;
    pulse.begun = g_get_monotonic_time();
    pulse.poll = g_main_context_get_poll_func(NULL);
    g_main_context_set_poll_func(NULL, watched_poll);
    pulse.all.since = pulse.recent.since = g_get_monotonic_time();
}

gboolean app_pulse_is_on(void)
{
    return pulse.is_on;
}

void app_pulse_picture(void)
{
    if (!pulse.first) {
        pulse.first_seconds = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
        pulse.first = g_get_monotonic_time();
    }
    pulse.all.pictures++;
    pulse.recent.pictures++;
}

static void painted(void)
{
    pulse.all.frames++;
}

static void watch_clock(GtkWidget *window)
{
    g_signal_connect(gtk_widget_get_frame_clock(window), "after-paint", G_CALLBACK(painted), NULL);
}

void app_pulse_watch(GtkWidget *window)
{
    if (pulse.is_on)
        g_signal_connect(window, "realize", G_CALLBACK(watch_clock), NULL);
}

/* The time in ms that so great a share of the turns stayed below. */
static double quantile(const Count *count, double share)
{
    guint64 wanted = (guint64)(share * (double)count->turns), found = 0;
    for (int i = 0; i < BINS; i++)
        if ((found += count->bins[i]) > wanted)
            return (i + 1) * BIN_MICROSECONDS / 1000.0;
    return (double)count->longest / 1000;
}

char *app_pulse_recent(void)
{
    double seconds = (double)(g_get_monotonic_time() - pulse.recent.since) / G_USEC_PER_SEC;
    char rate[24], longest[24];
    g_ascii_formatd(rate, sizeof rate, "%.0f", (double)pulse.recent.pictures / MAX(seconds, 1e-3));
    g_ascii_formatd(longest, sizeof longest, "%.1f", (double)pulse.recent.longest / 1000);
    /* TRANSLATORS: pictures for a second, and the longest time in ms that the program did not answer */
    char *text = g_strdup_printf(_("%s pictures/s, busy for up to %s ms"), rate, longest);
    pulse.recent = (Count){.since = g_get_monotonic_time()};
    return text;
}

void app_pulse_print(void)
{
    enum { NUMBERS = 9 };
    char numbers[NUMBERS][24];
    const double loop = seconds_of(CLOCK_THREAD_CPUTIME_ID) - pulse.all.loop_seconds;
    const double others = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - pulse.all.all_seconds - loop;
    const double frame = 1000 / (double)MAX(pulse.all.frames, 1);
    const double seconds = (double)(g_get_monotonic_time() - pulse.all.since) / G_USEC_PER_SEC;
    const double values[NUMBERS] = {seconds,
                              quantile(&pulse.all, 0.5),
                              quantile(&pulse.all, 0.99),
                              quantile(&pulse.all, 0.999),
                              (double)pulse.all.longest / 1000,
                              (double)(pulse.first - pulse.begun) / 1000,
                              1000 * pulse.first_seconds,
                              loop * frame,
                              others * frame};
    for (int i = 0; i < NUMBERS; i++)
        g_ascii_formatd(numbers[i], sizeof numbers[i], "%.2f", values[i]);
    if (!pulse.first)
        return;
    printf(_("start to first picture: %s ms, %s ms of processor time\n"), numbers[5], numbers[6]);
    printf(_("then pictures: %llu in %s s\n"), (unsigned long long)pulse.all.pictures, numbers[0]);
    printf(_("main loop busy, ms: median %s, 99 %% %s, 99.9 %% %s, longest %s\n"), numbers[1], numbers[2], numbers[3],
           numbers[4]);
    printf(_("processor time for each of %llu frames, ms: main loop %s, other threads %s\n"),
           (unsigned long long)pulse.all.frames, numbers[7], numbers[8]);
}
