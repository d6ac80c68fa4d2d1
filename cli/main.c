/* SPDX-License-Identifier: MIT */
/* The tool's way in and out: standard streams, dispatch to a command, exit code. */
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <luxel/luxel.h>

#include "../front/language.h"
#include "cli.h"
#include "json.h"
#include "message.h"
#include "options.h"
#include "progress.h"
#include "standard_output.h"

/*
 * A standard stream that the caller closed must not become the first file that is opened.  Each is replaced by
 * one that fails in its own use: input that cannot be read, output that cannot be written.
 */
static void keep_standard_streams(void)
{
    static const int modes[] = {O_WRONLY, O_RDONLY, O_RDONLY};

    for (int i = 0; i < (int)COUNT_OF(modes); i++)
        if (fcntl(i, F_GETFD) < 0 && errno == EBADF && open("/dev/null", modes[i]) < 0)
            _exit(EXIT_FILE);
}

/*
 * Results that did not arrive are an error, whatever else went well; but a reader who has seen enough, such as head,
 * may go away.
 */
static int finish_output(int code)
{
    const bool is_whole = fflush(stdout) == 0 && !ferror(stdout);

    if (is_whole ? fclose(stdout) == 0 : standard_output_reader_left())
        return code;
    message_error(_("standard output could not be written: %s"), language_reason(errno));
    return EXIT_FILE;
}

/* The set that a computation without further wishes would take. */
static void print_version(bool as_json)
{
    const char *forced = getenv("LUXEL_ISA");
    const char *name = luxel_instruction_set_chosen(NULL);
    struct json json = {.stream = stdout};

    if (as_json) {
        json_open(&json, NULL, '{');
        json_text(&json, "version", luxel_version());
        json_text(&json, "instruction_set", name);
        json_close(&json, '}');
        return;
    }
    printf("luxel %s\n", luxel_version());
    if (name)
        printf(_("instruction set: %s\n"), name);
    else
        printf(_("instruction set: none, this machine has no \"%s\"\n"), forced ? forced : "");
}

static int run(const struct options *options)
{
    if (options->version) {
        print_version(options->json);
        return EXIT_DONE;
    }
    if (options->help && options->command) {
        help_print_command(options->command);
        return EXIT_DONE;
    }
    if (options->command)
        return options->command->run(options);
    help_print_usage();
    return EXIT_DONE;
}

int main(int argc, char **argv)
{
    struct options options;
    int code;

    keep_standard_streams();
    language_begin();
    signal(SIGPIPE, SIG_IGN); /* a reader who goes away costs no file */
    signal(SIGXFSZ, SIG_IGN); /* a file that may not grow is told as one on a full disk */
    progress_catch_interrupt();
    code = options_read(argc, argv, &options);
    progress_wait(options.settings.within, options.keeps);
    if (code == EXIT_DONE)
        code = run(&options);
    if (progress_tell_end(options.quiet) && (code == EXIT_DONE || code == EXIT_TOLERANCE))
        code = EXIT_INTERRUPTED;
    options_clear(&options);
    return finish_output(code);
}
