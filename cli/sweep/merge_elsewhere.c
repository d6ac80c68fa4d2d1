/* SPDX-License-Identifier: MIT */
/* HDF5 files, handed to luxel-hdf5: its library would slow every start of the tool. */
#include "../../front/language.h"
#include "../cli.h"
#include "../elsewhere.h"
#include "../message.h"
#include "merge.h"

int sweep_merge_hdf5(struct sweep *sweep, const struct options *options)
{
    int reason;

    folder_close(&sweep->folder); /* the other one takes the lock */
    reason = elsewhere_run("luxel-hdf5", options->arguments);
    message_error(_("luxel sweep cannot run luxel-hdf5, which writes .h5 files: %s"), language_reason(reason));
    message_hint(_("install the package luxel-hdf5 or build Luxel where HDF5 is (libhdf5-dev), or merge into .npy "
                   "files"));
    return EXIT_FILE;
}
