# SPDX-License-Identifier: MIT
# A thin layer over Meson: what people type.  `make help` lists it.
BUILD ?= build
PREFIX ?= /usr/local
# Arguments for `luxel render` in `make run`, and for `meson test` in the checks.
RUN ?= -o report.png
# Arguments of luxel-app in `make app`.
APP ?=
TESTS ?=
# Options for the build folders of the checks: CONFIGURE=-Dinstruction_sets=x86-64-v3 builds fewer kernels, which take
# compilers most of their time.
CONFIGURE ?=
# Compilers for `make check-sanitize`.
SANITIZE ?= gcc clang

# Asked for anew each time, because `make setup` may just have installed them.  The distribution's own come first:
# others in PATH may run on a Python that lacks the modules that the tests need.
MESON = $(shell test -x /usr/bin/meson && echo /usr/bin/meson || echo meson)
PYTHON = $(shell test -x /usr/bin/python3 && echo /usr/bin/python3 || echo python3)
JOBS = $(shell nproc 2>/dev/null || echo 2)
# Tests wait for windows, files and processes at times; one more of them than processors fills these gaps.
PROCESSES = $(shell expr $(JOBS) + 1)

COMPILE = $(MESON) compile -j $(JOBS) -C
RUN_TESTS = $(PYTHON) tools/run_tests.py $(MESON)
VALGRIND = valgrind -q --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite,indirect,possible \
    --suppressions=$(CURDIR)/tests/valgrind.txt
WARNINGS_ARE_ERRORS = --werror

# One thing at a time: the parallel work is Ninja's.
.NOTPARALLEL:
.PHONY: build help setup run app python check quick check-long check-nightly bench install clean compile-clang \
    check-clang check-sanitize check-threads check-valgrind format fuzz coverage fuzz-coverage mutants properties frozen \
    freeze docs validation abi po packages check-packages check-kills check-wheel check-aarch64 notebook web check-web windows check-windows \
    npm check-npm wheels check-wheels linux check-linux release check-release

build: $(BUILD)/build.ninja
	@$(COMPILE) $(BUILD)

help:
	@echo 'make                 build the library and the luxel command in $(BUILD)/'
	@echo 'make setup           install what is missing for that (Debian; uses sudo when not root)'
	@echo 'make run             build, compute the scene "report", print its table, write report.png'
	@echo 'make app             build and start the desktop app; APP="scene.yaml" opens a scene'
	@echo 'make python          build the Python package in $(BUILD)/python: PYTHONPATH=$(BUILD)/python python3'
	@echo 'make check           build and run the tests; ends with "N passed, N failed"'
	@echo 'make quick           those that take seconds, for the work between two checks'
	@echo 'make check-long      those that take long: random scenes, most windows of the app, large files, old processors'
	@echo 'make check-nightly   all that takes too long for each change: before a release, or each night'
	@echo 'make compile-clang   compiles everything with clang, warnings being errors'
	@echo 'make check-clang     the tests, built by clang'
	@echo 'make check-sanitize  the same with address and undefined-behaviour sanitizers (SANITIZE="gcc clang")'
	@echo 'make check-threads   what computes in several threads, watched by the thread sanitizer'
	@echo 'make check-aarch64   builds the library and the command for aarch64 and tries them by an emulator'
	@echo 'make check-valgrind  the unit tests, and the command with every scene and format, under valgrind'
	@echo 'make fuzz            look for inputs that break something: MINUTES=5 a target, FUZZ="scene edit"'
	@echo 'make coverage        which lines and branches of src/ the tests reach, as a table of the rooms'
	@echo 'make fuzz-coverage   what of the files that it aims at each fuzz target reaches'
	@echo 'make mutants         whether tests fail when the library is made wrong; MUTANTS="--random 100 --seed 1"'
	@echo 'make properties      try what must hold of any scene on random ones: SCENES=1000000 of them, from SEED=1 on,'
	@echo '                     one light in EXTENDED=64 an extended source'
	@echo 'make check-kills     kill a sweep KILLS=200 times at random moments: the bytes must be the same at the end'
	@echo 'make frozen          whether pictures still have the bytes that tests/frozen/ holds; make freeze takes new ones'
	@echo 'make bench           time pictures and other programs in turn, and write docs/PERFORMANCE.md'
	@echo 'make install         install under PREFIX ($(PREFIX)); DESTDIR is honoured'
	@echo 'make docs            the reference pages of the library in $(BUILD)/docs/reference/html, by Doxygen'
	@echo 'make validation      write docs/VALIDATION.md anew from what the built command gives'
	@echo 'make packages        the Debian packages in $(BUILD)/packages, judged by lintian'
	@echo 'make check-packages  the same, installed into a fresh Debian and tried there'
	@echo 'make check-wheel     the Python package as a wheel in $(BUILD)/wheel, installed into a fresh environment and tried'
	@echo 'make wheels          the Python package as a wheel for other systems, and its sources, in build/wheels'
	@echo 'make check-wheels    the same, installed into fresh environments of every Python from 3.11 on that is here'
	@echo 'make linux           the tool, the app and the page as an archive for any folder, in build/linux'
	@echo 'make check-linux     the same, tried with an empty environment, and in a root folder of its own'
	@echo 'make npm             the packages luxel-core and luxel-scene for npm, in build/npm'
	@echo 'make check-npm       the same, installed and tried in Node, a plain page, Vite and esbuild'
	@echo 'make release         all that others are given, in build/release, with sums; PARTS="page npm" for some of it'
	@echo 'make check-release   the same made twice, whose bytes must be the same'
	@echo 'make web             the web page in build-web/page: static files, for any server, and luxel.html alone'
	@echo 'make windows         luxel.exe and luxel.dll for 64-bit Windows and luxel-windows.zip, in build/windows'
	@echo 'make check-windows   the same, tried by Wine; ends with "N passed, N failed"'
	@echo 'make check-web       the same, tried in Node and in Chromium; ends with "N passed, N failed"'
	@echo 'make notebook        write docs/python/tutorial.ipynb anew from docs/PYTHON.md'
	@echo 'make abi             add new functions and members of structures to the lists of tests/abi'
	@echo 'make format          format the C sources with clang-format'
	@echo 'make po              take new texts from the sources into the translations (po/)'
	@echo 'make clean           remove what was built'
	@echo
	@echo 'Variables: BUILD (build folder), RUN (arguments of luxel render), TESTS (arguments of meson test),'
	@echo 'CONFIGURE (options of meson setup for check-clang, packages and check-wheel).'

setup:
	@tools/setup

# Order-only: what is installed does not make the build folder old; Ninja knows when to configure again.
$(BUILD)/build.ninja: | setup
	@$(MESON) setup $(BUILD) --prefix $(PREFIX)

run: setup $(BUILD)/build.ninja
	@$(COMPILE) $(BUILD) luxel:executable
	@$(BUILD)/cli/luxel render $(RUN)

# Its settings are kept as an installed one's are, by the schema in the build folder.
app: setup build
	@test -x $(BUILD)/app/luxel-app || { echo 'the app was not built: GTK 4.8 or newer, cairo and pango are needed' >&2; exit 1; }
	@GSETTINGS_SCHEMA_DIR=$(BUILD)/data/desktop $(BUILD)/app/luxel-app $(APP)

# It lies in the build folder as it is installed.
python: setup $(BUILD)/build.ninja
	@$(MESON) introspect $(BUILD) --targets | grep -q '"_luxel"' || $(MESON) configure $(BUILD) -Dpython=enabled
	@$(COMPILE) $(BUILD) python
	@echo 'PYTHONPATH=$(BUILD)/python python3 -c "import luxel"'

check: setup build
	@$(RUN_TESTS) $(BUILD) --num-processes $(PROCESSES) $(if $(TESTS),$(TESTS),--no-suite campaign)

# What tells most for the time: unit tests with a fifth of their random scenes, and the checks of the sources.  Only what
# these need is built.
quick: setup $(BUILD)/build.ninja
	@LUXEL_CAMPAIGN=$(CAMPAIGN) $(RUN_TESTS) $(BUILD) --num-processes $(PROCESSES) --suite unit --suite house --suite fuzz \
	    --no-suite long --no-suite pixels --no-suite campaign $(TESTS)

# What takes long and is tried in short by `make check`.
check-long: setup build
	@$(RUN_TESTS) $(BUILD) --num-processes $(PROCESSES) --suite campaign $(TESTS)

# A release's check, and each night's; STEPS='web wheel' runs some of it.
STEPS ?=
check-nightly:
	@STEPS='$(STEPS)' .ci/nightly

# Whole or not at all, as the page of the validation.
bench: build
	@$(PYTHON) bench/compare.py $(BUILD) >$(BUILD)/PERFORMANCE.md && cp $(BUILD)/PERFORMANCE.md docs/PERFORMANCE.md
	@cat docs/PERFORMANCE.md

# Warnings come from the compiler's front end, which needs no optimization (and none about that it was not made); code is
# not run here.
compile-clang:
	@tools/setup clang
	@test -e build-warnings/build.ninja || CC=clang CXX=clang++ $(MESON) setup build-warnings $(WARNINGS_ARE_ERRORS) \
	    -Doptimization=0 -Ddebug=false -Dc_args=-Wno-pass-failed $(SANITIZED_SETS)
	@$(COMPILE) build-warnings

check-clang:
	@tools/setup clang
	@test -e build-clang/build.ninja || CC=clang CXX=clang++ $(MESON) setup build-clang $(WARNINGS_ARE_ERRORS) $(CONFIGURE)
	@$(COMPILE) build-clang
	@$(RUN_TESTS) build-clang --num-processes $(JOBS) $(TESTS)

# How many of the random scenes of unit tests are tried where all takes many times as long, in per cent of the usual.
CAMPAIGN ?= 20

# Kernels take sanitizers' compilers most of the time; one set of vectors tells as much as three.
SANITIZED_SETS = -Dinstruction_sets=x86-64-v3

# Only what the tests need is built.  The sanitizers' runtime is not linked into shared libraries by clang:
# b_lundef=false.  What the libraries that draw keep to the end is in tests/leaks.txt.
check-sanitize: $(SANITIZE:%=sanitize-%)

sanitize-%:
	@tools/setup $(filter clang,$*)
	@test -e build-sanitize-$*/build.ninja || CC=$* $(MESON) setup build-sanitize-$* $(WARNINGS_ARE_ERRORS) \
	    -Db_sanitize=address,undefined -Db_lundef=false -Doptimization=1 $(SANITIZED_SETS)
	@UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1 ASAN_OPTIONS=detect_stack_use_after_return=1 \
	    LSAN_OPTIONS=suppressions=$(CURDIR)/tests/leaks.txt:print_suppressions=0 LUXEL_CAMPAIGN=$(CAMPAIGN) \
	    $(RUN_TESTS) build-sanitize-$* --num-processes $(JOBS) --timeout-multiplier 10 $(TESTS)

# What threads do to one another, by gcc's sanitizer, which has to see every access: only what these tests need is built.
# tests/races.txt lists what it cannot know; GLib's own allocator hands memory from thread to thread under locks that the
# sanitizer does not see, so malloc() stands in for it.
check-threads: setup
	@test -e build-threads/build.ninja || CC=gcc $(MESON) setup build-threads $(WARNINGS_ARE_ERRORS) \
	    -Db_sanitize=thread -Db_lundef=false -Doptimization=1 $(SANITIZED_SETS)
	@G_SLICE=always-malloc TSAN_OPTIONS=suppressions=$(CURDIR)/tests/races.txt LUXEL_CAMPAIGN=$(CAMPAIGN) \
	    $(RUN_TESTS) build-threads --num-processes $(JOBS) --timeout-multiplier 10 --suite threads $(TESTS)

check-aarch64:
	@tools/setup aarch64
	@tools/check_aarch64 build-aarch64

# Each target so long, one after the other; what it finds lies in build-fuzz/findings/TARGET, to be mended and then put
# into fuzz/corpus/TARGET.  The corpus itself is not changed.
MINUTES ?= 5
FUZZ ?= scene edit field mesh numbers answers arguments photometry points
fuzz:
	@tools/setup clang
	@test -e build-fuzz/build.ninja || CC=clang CXX=clang++ $(MESON) setup build-fuzz -Dfuzz=true -Dfigures=disabled \
	    -Db_sanitize=address,undefined -Db_lundef=false -Doptimization=1 -Dc_args=-fsanitize=fuzzer-no-link
	@$(COMPILE) build-fuzz $(FUZZ:%=fuzz-%)
	@for target in $(FUZZ); do \
	    mkdir -p build-fuzz/findings/$$target build-fuzz/corpus/$$target && \
	    UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1 \
	    LSAN_OPTIONS=suppressions=$(CURDIR)/fuzz/leaks.txt:print_suppressions=0 \
	        build-fuzz/fuzz/fuzz-$$target -max_total_time=$$(($(MINUTES) * 60)) -timeout=10 -rss_limit_mb=4096 \
	        -print_final_stats=1 -artifact_prefix=build-fuzz/findings/$$target/ \
	        $$(test ! -e fuzz/dictionaries/$$target.dict || echo -dict=fuzz/dictionaries/$$target.dict) \
	        build-fuzz/corpus/$$target fuzz/corpus/$$target >build-fuzz/$$target.log 2>&1; code=$$?; \
	    echo "$$target: $$(grep number_of_executed_units build-fuzz/$$target.log | tr -dc 0-9) inputs, rc $$code"; \
	    test $$code = 0 || { tail -40 build-fuzz/$$target.log; exit 1; }; \
	done

# Lines and branches of src/ that the tests reach: tools/coverage.py.  Counters are atomic for the sake of threads.
COVERED ?= unit formats reference cli figure fuzz
coverage: build-coverage/build.ninja
	@tools/setup coverage
	@$(COMPILE) build-coverage
	@find build-coverage -name "*.gcda" -delete
	@code=0; $(RUN_TESTS) build-coverage --num-processes $(JOBS) --timeout-multiplier 10 \
	    $(COVERED:%=--suite %) $(TESTS) || code=1; $(PYTHON) tools/coverage.py build-coverage; exit $$code

build-coverage/build.ninja: | setup
	@CC=gcc $(MESON) setup build-coverage -Db_coverage=true -Dapp=disabled -Doptimization=g \
	    -Dc_args=-fprofile-update=atomic

# What of the files that it aims at each target reaches, by fuzz/corpus and what `make fuzz` has grown.
fuzz-coverage: build-coverage/build.ninja
	@tools/setup coverage
	@$(COMPILE) build-coverage $(FUZZ:%=replay-%)
	@$(PYTHON) fuzz/coverage.py build-coverage build-fuzz/corpus $(FUZZ)

# Hours on a small machine.  The sources are copied to build-mutants and made wrong there.
MUTANTS ?=
mutants: setup
	@$(PYTHON) tools/mutate.py build-mutants $(MUTANTS)

# What fails is made as small as it can be, and told with the seed that repeats it.
SCENES ?= 1000000
SEED ?= 1
EXTENDED ?= 64
properties: setup $(BUILD)/build.ninja
	@$(COMPILE) $(BUILD) properties:executable
	@$(BUILD)/tests/properties/properties --scenes $(SCENES) --seed $(SEED) --extended $(EXTENDED)

# A sweep that is killed so many times at random moments, and must end with the same bytes.
KILLS ?= 200
check-kills: build
	@LUXEL_SWEEP_KILLS=$(KILLS) $(RUN_TESTS) $(BUILD) --timeout-multiplier 10 'cli sweep'

# For changes that must move no byte of a picture.
frozen freeze: setup $(BUILD)/build.ninja
	@$(COMPILE) $(BUILD) freeze
	@$(PYTHON) tests/frozen/frozen.py $(BUILD)/tests/frozen/freeze $(if $(filter freeze,$@),--write)

check-valgrind: build
	@tools/setup valgrind
	@PYTHONPATH=tests PYTHONDONTWRITEBYTECODE=1 $(PYTHON) tests/cli/under_valgrind.py $(BUILD)/cli/luxel $(VALGRIND)
	@LUXEL_CAMPAIGN=$(CAMPAIGN) $(RUN_TESTS) $(BUILD) --num-processes $(JOBS) --suite unit --suite fuzz --no-suite long \
	    --timeout-multiplier 50 --wrapper='$(VALGRIND)' $(TESTS)

# A PREFIX that is given now holds, whatever the folder was configured for.
install: $(BUILD)/build.ninja
	@$(if $(filter command environment,$(firstword $(origin PREFIX))),$(MESON) configure $(BUILD) --prefix $(PREFIX))
	@$(COMPILE) $(BUILD)
	@$(MESON) install -C $(BUILD) --no-rebuild
	@test -n "$(DESTDIR)" || test "$$(id -u)" != 0 || ldconfig 2>/dev/null || true

docs: $(BUILD)/build.ninja
	@tools/setup docs
	@test -e $(BUILD)/docs/reference/Doxyfile || $(MESON) setup --reconfigure $(BUILD) >/dev/null
	@$(COMPILE) $(BUILD) docs
	@echo "$(BUILD)/docs/reference/html/index.html"

# Whole or not at all, so that a failure leaves the old page.
validation: build
	@PYTHONPATH=tests PYTHONDONTWRITEBYTECODE=1 $(PYTHON) tests/reference/make_validation.py $(BUILD)/cli/luxel \
	    >$(BUILD)/VALIDATION.md && cp $(BUILD)/VALIDATION.md docs/VALIDATION.md
	@echo docs/VALIDATION.md

abi: build
	@$(COMPILE) $(BUILD) abi layout

packages:
	@tools/setup packages
	@CONFIGURE='$(CONFIGURE)' tools/packages $(BUILD)/packages

check-packages: packages
	@tools/check_packages $(BUILD)/packages

notebook:
	@$(PYTHON) tools/make_notebook.py docs/PYTHON.md docs/python/tutorial.ipynb --write

check-wheel:
	@tools/setup wheel
	@CONFIGURE='$(CONFIGURE)' tools/check_wheel $(BUILD)/wheel

# The core by emscripten, whatever BUILD is, and the page by Vite.
web:
	@tools/setup web
	@tools/web_page build-web

check-web: web setup $(BUILD)/build.ninja
	@$(COMPILE) $(BUILD) luxel:executable
	@node web/tests/run.mjs build-web $(abspath $(BUILD))/cli/luxel

# What others install by npm; it has the core and the page that `make web` builds.
npm: web
	@tools/npm build-web build/npm

check-npm: npm setup $(BUILD)/build.ninja
	@$(COMPILE) $(BUILD) luxel:executable
	@node web/npm/test.mjs build/npm $(abspath $(BUILD))/cli/luxel

wheels:
	@tools/setup wheel
	@CONFIGURE='$(CONFIGURE)' tools/wheels build/wheels

check-wheels: wheels
	@tools/check_wheels build/wheels

linux: setup
	@CONFIGURE='$(CONFIGURE)' tools/linux/build build/linux

check-linux: linux $(BUILD)/build.ninja
	@$(COMPILE) $(BUILD) luxel:executable
	@tools/check_linux build/linux $(BUILD)/cli/luxel

# CONFIGURE holds for all parts.
release:
	@CONFIGURE='$(CONFIGURE)' PARTS='$(PARTS)' ADDRESS='$(ADDRESS)' tools/release build/release

check-release: release
	@CONFIGURE='$(CONFIGURE)' PARTS='$(PARTS)' ADDRESS='$(ADDRESS)' tools/check_release build/release

# luxel.exe by mingw-w64, whatever BUILD is.
windows:
	@tools/setup windows
	@CONFIGURE='$(CONFIGURE)' tools/windows/build build/windows

check-windows: windows setup $(BUILD)/build.ninja
	@tools/setup wine
	@$(COMPILE) $(BUILD) luxel:executable luxel-draw:executable luxel-gmo
	@PYTHONPATH=tests PYTHONDONTWRITEBYTECODE=1 $(PYTHON) tests/windows/test_windows.py $(BUILD)/cli/luxel \
	    build/windows/luxel.exe build/windows/wine

# What is not translated yet is listed at the end.
po: setup $(BUILD)/build.ninja
	@$(COMPILE) $(BUILD) luxel-pot
	@for language in $$(grep -v '^#' po/LINGUAS); do \
	    msgmerge --quiet --update --backup=none --no-fuzzy-matching --add-location=file po/$$language.po po/luxel.pot && \
	    msgattrib --no-obsolete --output-file=po/$$language.po po/$$language.po && \
	    msgattrib --untranslated --no-location po/$$language.po && \
	    msgfmt --check --statistics --output-file=/dev/null po/$$language.po || exit 1; \
	done

format:
	@find include src front cli app python tests bench fuzz -name '*.[ch]' 2>/dev/null | xargs clang-format -i

clean:
	@rm -rf $(BUILD) build-clang build-warnings build-fuzz build-coverage build-threads build-mutants build-sanitize-gcc \
	    build-sanitize-clang build-web build-linux build-static build-wheel build-aarch64 web/node_modules
