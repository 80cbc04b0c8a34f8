"""How the labels network comes about: sheets are drawn, it is trained on them, checked, written.

    python -m learning --help

It is for a checkout: nothing here is in the wheel, and nothing of the engine imports it.  README.md
beside this file tells the whole way.
"""
