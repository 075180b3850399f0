# The newcomer's commands. Each installs what it needs (Debian 11 to 13, as root or by sudo) and works as
# the very first one after the clone.
SHELL := /bin/bash
.DEFAULT_GOAL := help
MAKEFLAGS += --no-print-directory
JOBS ?= $(shell nproc)
# Half of the tests wait for a ROS master most of the time.
TESTS = $(shell echo $$((2 * $(JOBS))))
GROUP :=
# Debian's Python, which ROS belongs to, whichever other is in the path.
PYTHON := -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3
SANITIZER_OPTIONS := ASAN_OPTIONS=detect_stack_use_after_return=1 UBSAN_OPTIONS=print_stacktrace=1 \
  LSAN_OPTIONS=suppressions=$(CURDIR)/cmake/leaks.supp \
  TSAN_OPTIONS=suppressions=$(CURDIR)/cmake/races.supp RIBBON_MAPPER_MUTATIONS=10000

build: ## install what is needed, configure and build
	./install_dependencies $(GROUP)
	cmake -S . -B build $(PYTHON)
	cmake --build build -j $(JOBS)

test: GROUP = test
test: build ## all tests
	cd build && ctest -j $(TESTS) --output-on-failure

# A port of its own, so that a ROS master which runs already is left alone.
demo: export ROS_MASTER_URI = http://localhost:11411
demo: export ROS_HOSTNAME = localhost
demo: GROUP = $(if $(findstring rviz:=true,$(ARGS)),rviz)
demo: build ## a simulated flat, corrected by the truth, then by the slam; results in results/
	source build/devel/setup.bash && tools/demo $(ARGS)

# The real recordings with their presets.
bench: RECORDINGS = --bag test/data/recordings/room_scan1.bag --bag-config config/room_scan.yaml \
  --bag test/data/recordings/room_240.bag --bag-config config/urg04lx.yaml
bench: ## speed and memory beside the packaged peers, results in results/bench
	./install_dependencies bench
	cmake -S . -B build -DRIBBON_MAPPER_BENCH=ON \
	  $(PYTHON)
	cmake --build build --target bench -j $(JOBS)
	build/devel/lib/ribbon_mapper/bench $(RECORDINGS) $(ARGS)

# The build is gcc's part: its warnings are errors from the first `make lint` of a build folder on.
# The benchmarks are built here, as no test does.
lint: GROUP = test lint bench
lint: ## format, names, bug-prone code and warnings of gcc and clang; below a minute if little changed
	./install_dependencies $(GROUP)
	tools/lint --format-only
	cmake -S . -B build -DRIBBON_MAPPER_WERROR=ON -DRIBBON_MAPPER_BENCH=ON $(PYTHON)
	cmake --build build -j $(JOBS)
	tools/lint --jobs $(JOBS)

# Not run under the sanitizers: nodes with a ROS master, budgets of instructions and allocations,
# and what checks text. Eigen's assertions are on: the build type is Debug.
WITHOUT := rostest|instruction_budget|allocations_test|architecture|documented|house_table|installed_test|lint_test|package_xml|pages|commands|ros_files
UNDEFINED := undefined,float-cast-overflow,float-divide-by-zero
sanitize: GROUP = test
sanitize: ## all tests without a ROS master under AddressSanitizer and UBSan, in build/sanitize
	./install_dependencies $(GROUP)
	cmake -S . -B build/sanitize -DCMAKE_BUILD_TYPE=Debug \
	  -DRIBBON_MAPPER_SANITIZE=address,$(UNDEFINED) $(PYTHON)
	cmake --build build/sanitize -j $(JOBS)
	cd build/sanitize && $(SANITIZER_OPTIONS) ctest -j $(JOBS) -E '$(WITHOUT)' --output-on-failure

# Series of runs, the laser and the node slam have threads.
tsan: GROUP = test
tsan: ## what has threads under ThreadSanitizer, in build/tsan
	./install_dependencies $(GROUP)
	cmake -S . -B build/tsan -DCMAKE_BUILD_TYPE=Debug -DRIBBON_MAPPER_SANITIZE=thread $(PYTHON)
	cmake --build build/tsan -j $(JOBS) --target eval_test live_slam_test sim_test experiment
	cd build/tsan && $(SANITIZER_OPTIONS) ctest --output-on-failure \
	  -R '^(eval_test|live_slam_test|sim_test|series_command_test)$$'

# In a copy of the sources, as dpkg writes beside them; hidden, as roslaunch finds files in all other folders.
deb: GROUP = deb
deb: ## Debian packages, in build/deb; on Debian 12
	@. /etc/os-release; test "$$VERSION_ID" = 12 || \
	  { echo "make deb: this is no Debian 12; others lack libsdformat-dev or libcli11-dev" >&2; false; }
	./install_dependencies $(GROUP)
	rm -rf build/deb && mkdir -p build/deb/.source
	tar -c --exclude-vcs --exclude=./build --exclude=./devel --exclude=./results . | tar -x -C build/deb/.source
	cd build/deb/.source && DEB_BUILD_OPTIONS=parallel=$(JOBS) dpkg-buildpackage -us -uc -b
	lintian --fail-on error build/deb/*.changes

clean: ## forget everything that was built
	rm -rf build devel

help: ## this list
	@grep -E '^[a-z]+:.*##' Makefile | sed 's/:.*##/\t/'

.PHONY: build test demo bench lint sanitize tsan deb clean help
