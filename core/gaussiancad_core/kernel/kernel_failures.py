"""What OpenCASCADE raises.

In Python its exceptions have no base class of their own: the class that is one in C++,
``Standard_Failure``, catches none of the others.
"""

from inspect import getmembers, isclass, ismodule

from OCP import OCP

KERNEL_FAILURES: tuple[type[Exception], ...] = tuple(
    each
    for _, module in getmembers(OCP, ismodule)
    for _, each in getmembers(module, isclass)
    if issubclass(each, Exception)
)
"""All that an operation on shapes may end by, where it is not done."""
