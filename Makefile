# What a checkout can do; `make help` lists it.  The work is in scripts/.
.DEFAULT_GOAL := help
.NOTPARALLEL:
.PHONY: help install demo test test-engine test-workbench test-gui test-freecad-latest lint bench \
	lock clean

help: ## this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-20s %s\n", $$1, $$2 }' Makefile

install: ## the system packages (Debian) and the engine's environment in .venv
	@sh scripts/install_system.sh
	@sh scripts/install_engine.sh

lock: ## pin the engine's and the tests' packages anew; UPGRADE=1 takes the newest ones
	@sh scripts/lock.sh $(if $(UPGRADE),--upgrade)
