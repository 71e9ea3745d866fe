# Corpuscle: the few words a visitor types. The build itself is CMake's (CMakePresets.json).
#
#   make demo       installs what is missing, builds, runs the plate of examples/01_plate, says where its report is
#   make test       installs what is missing, builds, runs every test and every check of the house
#   make build      the program alone: build/release/app/corpuscle
#   make validate   the runs behind the tables of docs/validation.md (long); TOPICS="plate" for one of tools/validation
#   make paper      the figures and tables of docs/paper.md alone (hours)
#   make bench      what is timed
#   make lint       the checks of the house alone: floors, layout, clang-tidy, sanitizers
#   make format     lays every source out as .clang-format says
#   make install    into PREFIX (/usr/local)
#   make clean      removes build/; results stay

JOBS ?= $(shell nproc)
PREFIX ?= /usr/local
BUILD := build/release
CORPUSCLE := $(BUILD)/app/corpuscle
DEMO := results/01_plate

.DEFAULT_GOAL := help
.PHONY: help demo test build configured tests validate paper bench lint format install clean

help:
	@sed -n '2,/^$$/s/^# \{0,1\}//p' Makefile

demo: build
	$(CORPUSCLE) run examples/01_plate/case.toml --out $(DEMO) --force
	@echo "report: $(CURDIR)/$(DEMO)/report.html"

# The program needs fewer packages than the tests: a tree that has no tests yet is configured without them.
build:
	@tools/bootstrap demo
	@[ -f $(BUILD)/build.ninja ] || cmake --preset release -DCORPUSCLE_TESTS=OFF
	cmake --build --preset release --target corpuscle -j $(JOBS)

configured:
	@tools/bootstrap test
	cmake --preset release -DCORPUSCLE_TESTS=ON

tests: configured
	cmake --build --preset release -j $(JOBS)

test: tests
	ctest --test-dir $(BUILD) -j $(JOBS) --output-on-failure --no-tests=error

validate: tests
	tools/validate.py $(BUILD) $(TOPICS)

paper: build
	tools/validate.py $(BUILD) paper

bench: build
	@mkdir -p results
	$(CORPUSCLE) bench --out results/bench.json

lint: tests
	ctest --test-dir $(BUILD) -L house --output-on-failure --no-tests=error

format:
	@tools/bootstrap test
	tools/format

install: build
	cmake --install $(BUILD) --prefix $(PREFIX)

clean:
	rm -rf build
