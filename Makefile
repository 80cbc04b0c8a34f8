# What a checkout can do; `make help` lists it.  The work is done by scripts/.
.DEFAULT_GOAL := help
.NOTPARALLEL:
.PHONY: help install demo quick test coverage durations test-engine test-workbench test-gui test-freecad-latest lint bench \
	tutorial lock licences sbom vulnerabilities clean

help: ## this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-20s %s\n", $$1, $$2 }' Makefile

install: ## the system packages (Debian) and the engine's environment in .venv
	@sh scripts/install_system.sh
	@sh scripts/install_engine.sh

demo: install ## a sample sheet through FreeCAD: a document, a STEP file, a picture, a report in demo/
	@sh scripts/demo.sh

quick: install ## what to run after each change: the style, and all tests that are quick; three minutes on two cores
	@sh scripts/test.sh quick

test: install ## everything below but the last; twenty to thirty minutes on two cores
	@sh scripts/install_system.sh scripts/test-packages.txt
	@sh scripts/test.sh lint all

lint: install ## the style of all Python files
	@sh scripts/test.sh lint

test-engine: install ## the engine, and how its network is trained
	@sh scripts/test.sh engine

test-workbench: install ## the workbench without a window
	@sh scripts/test.sh workbench

test-gui: install ## the workbench in a real window, on a virtual screen
	@sh scripts/test.sh gui

test-freecad-latest: install ## workbench and window in Debian's next FreeCAD (root, 3 GB in /var/tmp)
	@sh tests/freecad_latest.sh

bench: install ## the figures that need no other people's drawings; two hours on two quiet cores
	@sh scripts/bench.sh

tutorial: install ## the pictures of the tutorial and the README anew, from FreeCAD's window
	@.venv/bin/python scripts/tutorial_pictures.py

coverage: install ## the share of the engine's lines that its tests run
	@.venv/bin/python -m pytest --quiet --numprocesses 2 --dist loadfile -m "not freecad" \
		--cov --cov-report=term:skip-covered

durations: install ## record the seconds of all tests: which are quick, and which begin first
	@sh scripts/install_system.sh scripts/test-packages.txt
	@.venv/bin/python -m pytest --quiet --numprocesses 3 --dist loadfile --no-loadscope-reorder --record-durations

lock: ## pin the engine's and the tests' packages anew; UPGRADE=1 takes the newest ones
	@sh scripts/lock.sh $(if $(UPGRADE),--upgrade)

licences: ## the locked packages with their licences; fails if one is not allowed
	@python3 scripts/licences.py

sbom: ## bills of materials of the locks (CycloneDX) in build/sbom/
	@sh scripts/supply.sh sbom

vulnerabilities: ## asks a public database for known vulnerabilities of the locked packages
	@sh scripts/supply.sh vulnerabilities

clean: ## remove what demo and the tests wrote, but keep .venv
	@rm -rf build demo .pytest_cache .ruff_cache .hypothesis
