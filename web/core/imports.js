// SPDX-License-Identifier: MIT
// Tells the linker what the page gives to the core; core.ts is who gives it.
mergeInto(LibraryManager.library, { page_translation: function () {}, page_opened: function () {}, page_progress: function () {} });
