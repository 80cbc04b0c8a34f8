"""What OpenCASCADE raises.

In Python its exceptions have no base class of their own: the class that is one in C++,
``Standard_Failure``, catches none of the others.
"""

import OCP.gp
import OCP.Standard
import OCP.StdFail

KERNEL_FAILURES: tuple[type[Exception], ...] = tuple(
    each
    for module in (OCP.Standard, OCP.StdFail, OCP.gp)
    for each in vars(module).values()
    if isinstance(each, type) and issubclass(each, Exception)
)
"""All that an operation on shapes may end by, where it is not done."""
