# The newcomer's commands. Each installs what it needs (Debian 12, as root or by sudo) and works as
# the very first one after the clone.
SHELL := /bin/bash
.DEFAULT_GOAL := help
JOBS ?= $(shell nproc)
GROUP :=

build: ## install what is needed, configure and build
	./install_dependencies $(GROUP)
	cmake -S . -B build -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3
	cmake --build build -j $(JOBS)

test: GROUP = test
test: build ## all tests
	ctest --test-dir build --output-on-failure

# A port of its own, so that a ROS master which runs already is left alone.
demo: export ROS_MASTER_URI = http://localhost:11411
demo: export ROS_HOSTNAME = localhost
demo: GROUP = $(if $(findstring rviz:=true,$(ARGS)),rviz)
demo: build ## the whole chain in a simulated flat, results in results/loop_closure
	source build/devel/setup.bash && roslaunch ribbon_mapper loop_closure.launch \
	  output:=$(CURDIR)/results/loop_closure $(ARGS)

# The real recordings with their presets.
bench: RECORDINGS = --bag test/data/recordings/room_scan1.bag --bag-config config/room_scan.yaml \
  --bag test/data/recordings/room_240.bag --bag-config config/urg04lx.yaml
bench: ## speed and memory beside the packaged peers, results in results/bench
	./install_dependencies bench
	cmake -S . -B build -DRIBBON_MAPPER_BENCH=ON \
	  -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3
	cmake --build build --target bench -j $(JOBS)
	build/devel/lib/ribbon_mapper/bench $(RECORDINGS) $(ARGS)

clean: ## forget everything that was built
	rm -rf build devel

help: ## this list
	@grep -E '^[a-z]+:.*##' Makefile | sed 's/:.*##/\t/'

.PHONY: build test demo bench clean help
