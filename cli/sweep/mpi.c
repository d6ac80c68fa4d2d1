/* SPDX-License-Identifier: MIT */
/*
 * luxel-sweep-mpi: luxel sweep by the ranks of an MPI job.
 *
 * MPI hands out the numbers of shards and nothing else: a counter in the memory of rank 0, from which each rank fetches
 * the next one (MPI_Fetch_and_op).  Shards go into the folder that all of them see, as with luxel sweep, so the bytes
 * are the same, and a job that ended early is gone on with by running it again, with any number of ranks.  A thread of
 * each rank computes, while its main thread keeps MPI going, so that rank 0 answers when it computes itself.
 */
#include <mpi.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <luxel/luxel.h>

#include "../../front/language.h"
#include "../cli.h"
#include "../message.h"
#include "../options.h"
#include "../text.h"
#include "sweep.h"

/* A rank: what its two threads share. */
struct rank {
    struct sweep sweep;
    int number, count; /* of this rank, and of all */
    MPI_Win window;
    uint64_t *next; /* of rank 0: the counter */
    atomic_bool is_busy;
    uint64_t shard; /* what the other thread computes */
    struct sweep_worker worker;
    int code;
};

/* The job is ended, as when another rank died: this rank finishes its shard first. */
static volatile sig_atomic_t is_ended;

static void on_end(int signal_number)
{
    (void)signal_number;
    is_ended = 1;
}

static uint64_t fetch_next(struct rank *rank)
{
    const uint64_t one = 1;
    uint64_t next = 0;

    MPI_Win_lock(MPI_LOCK_SHARED, 0, 0, rank->window);
    MPI_Fetch_and_op(&one, &next, MPI_UINT64_T, 0, 0, MPI_SUM, rank->window);
    MPI_Win_unlock(0, rank->window);
    return next;
}

static void pause_shortly(void)
{
    int flag;

    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &flag, MPI_STATUS_IGNORE);
    usleep(500);
}

static void *compute(void *data)
{
    struct rank *rank = data;
    const int code = sweep_shard(&rank->worker, rank->shard);

    if (code != EXIT_DONE)
        rank->code = code;
    atomic_store(&rank->is_busy, false);
    return NULL;
}

/* Computes a shard in a thread of its own; by itself where none can be had. */
static void compute_beside(struct rank *rank)
{
    pthread_t thread;

    folder_retract(&rank->sweep.folder, rank->shard);
    atomic_store(&rank->is_busy, true);
    if (pthread_create(&thread, NULL, compute, rank) != 0) {
        compute(rank);
        return;
    }
    while (atomic_load(&rank->is_busy))
        pause_shortly();
    pthread_join(thread, NULL);
}

/* Waits until every rank has come here, without burning a processor. */
static void wait_for_all(void)
{
    MPI_Request request;
    int done = 0;

    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    while (!done) {
        MPI_Test(&request, &done, MPI_STATUS_IGNORE);
        if (!done)
            usleep(500);
    }
}

static void work(struct rank *rank)
{
    const MPI_Aint bytes = rank->number == 0 ? sizeof *rank->next : 0;

    MPI_Win_allocate(bytes, sizeof *rank->next, MPI_INFO_NULL, MPI_COMM_WORLD, &rank->next, &rank->window);
    if (rank->number == 0)
        *rank->next = 0;
    wait_for_all();
    while (rank->code == EXIT_DONE && !is_ended) {
        rank->shard = fetch_next(rank);
        if (rank->shard >= rank->sweep.shards)
            break;
        if (!sweep_has(&rank->sweep, rank->shard))
            compute_beside(rank);
    }
    if (is_ended)
        _exit(EXIT_INTERRUPTED);
    wait_for_all();
    MPI_Win_free(&rank->window);
}

/* The folder is rank 0's to begin; the others come when it has, and not where it could not. */
static int open_folder(struct rank *rank, const char *path)
{
    int code = EXIT_DONE;

    for (int turn = 0; turn < 2; turn++) {
        if (code == EXIT_DONE && (rank->number == 0) == (turn == 0)) {
            code = folder_open(&rank->sweep.folder, path, (unsigned)rank->number, (unsigned)rank->count);
            if (code == EXIT_DONE)
                code = sweep_claim(&rank->sweep);
        }
        wait_for_all();
        if (turn == 0)
            MPI_Bcast(&code, 1, MPI_INT, 0, MPI_COMM_WORLD);
    }
    if (code == EXIT_DONE)
        code = sweep_worker_init(&rank->worker, &rank->sweep);
    return code;
}

/* Whether the study can be swept; what is wrong is the same for all ranks, and told by one. */
static int check(const struct rank *rank)
{
    int code = rank->number == 0 ? sweep_check(&rank->sweep) : EXIT_DONE;

    MPI_Bcast(&code, 1, MPI_INT, 0, MPI_COMM_WORLD);
    return code;
}

/* Exit code of all ranks: the worst that one of them met. */
static int agree(int code)
{
    int worst = code;

    MPI_Allreduce(&code, &worst, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return worst;
}

static int finish(struct rank *rank, bool quiet)
{
    uint64_t whole = 0;
    int code = EXIT_DONE;

    if (rank->number == 0)
        code = sweep_write_manifest(&rank->sweep, &whole);
    if (rank->number == 0 && !quiet) {
        text_print_escaped(stdout, rank->sweep.folder.path);
        printf(_(": whole shards: %llu of %llu, ranks: %d\n"), (unsigned long long)whole,
               (unsigned long long)rank->sweep.shards, rank->count);
    }
    return code;
}

static int sweep_by_ranks(struct rank *rank, const struct options *options, const luxel_study *study)
{
    int code;

    sweep_init(&rank->sweep, study, options->operand);
    code = check(rank);
    if (code == EXIT_DONE)
        code = agree(open_folder(rank, options->outputs[0]));
    if (code == EXIT_DONE) {
        work(rank);
        code = sweep_tell_missed(&rank->sweep); /* of its own scenes */
        code = agree(rank->code ? rank->code : code);
        sweep_worker_clear(&rank->worker);
        const int finished = agree(finish(rank, options->quiet));

        code = code ? code : finished;
    }
    sweep_clear(&rank->sweep);
    return code;
}

static int run(struct rank *rank, const struct options *options)
{
    luxel_diagnostics *diagnostics = message_new_diagnostics();
    luxel_study *study = NULL;
    luxel_status status;
    int code;

    if (!options->operand || options->output_count != 1 || options->dry_run || options_given(options, "show") ||
        options_given(options, "merge") || options_given(options, "shard") || options_given(options, "workers")) {
        if (rank->number == 0)
            message_error(_("usage: mpirun luxel-sweep-mpi STUDY -o FOLDER [-q]"));
        luxel_diagnostics_free(diagnostics);
        return EXIT_USAGE;
    }
    status = luxel_study_read_file(options->operand, diagnostics, &study);
    code = status == LUXEL_OK ? EXIT_DONE : rank->number == 0 ? message_failure(status, diagnostics) : EXIT_SCENE;
    code = agree(code);
    if (code == EXIT_DONE)
        code = sweep_by_ranks(rank, options, study);
    luxel_study_free(study);
    luxel_diagnostics_free(diagnostics);
    return code;
}

int main(int argc, char **argv)
{
    const struct sigaction action = {.sa_handler = on_end};
    struct rank rank = {0};
    struct options options;
    int provided, code;

    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank.number);
    MPI_Comm_size(MPI_COMM_WORLD, &rank.count);
    language_begin();
    signal(SIGXFSZ, SIG_IGN);
    sigaction(SIGTERM, &action, NULL);

    /* the command line of luxel sweep, with the same options */
    char **arguments = message_allocate((size_t)argc + 2, sizeof *arguments);

    arguments[0] = argv[0];
    arguments[1] = (char *)"sweep";
    memcpy(arguments + 2, argv + 1, (size_t)argc * sizeof *argv);
    code = options_read(argc + 1, arguments, &options);
    if (code == EXIT_DONE && options.version) {
        if (rank.number == 0)
            printf("luxel-sweep-mpi %s\n", luxel_version());
    } else if (code == EXIT_DONE && options.help) {
        if (rank.number == 0)
            printf(_("usage: mpirun luxel-sweep-mpi STUDY -o FOLDER [-q]\n"));
    } else if (code == EXIT_DONE) {
        code = run(&rank, &options);
    }
    options_clear(&options);
    free(arguments);
    MPI_Finalize();
    return code;
}
