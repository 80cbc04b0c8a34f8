# shellcheck shell=sh
# Sourced after steps.sh: the tools that write and ask the locks, in build/lock-tools.

if [ ! -x build/lock-tools/bin/pip-audit ]; then
    logged lock-venv python3 -m venv build/lock-tools
    logged lock-pip build/lock-tools/bin/python -m pip install 'uv>=0.13,<0.14' 'pip>=25' \
        'pip-audit>=2.7,<3' 'cyclonedx-bom>=7,<8'
fi
