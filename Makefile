# The newcomer's commands. Each installs what it needs (Debian 12, as root or by sudo) and works as
# the very first one after the clone.
SHELL := /bin/bash
.DEFAULT_GOAL := help
JOBS ?= $(shell nproc)

build: ## install what is needed, configure and build
	./install_dependencies
	cmake -S . -B build -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3
	cmake --build build -j $(JOBS)

test: build ## all tests
	ctest --test-dir build --output-on-failure

clean: ## forget everything that was built
	rm -rf build

help: ## this list
	@grep -E '^[a-z]+:.*##' Makefile | sed 's/:.*##/\t/'

.PHONY: build test clean help
