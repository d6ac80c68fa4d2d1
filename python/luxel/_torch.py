# SPDX-License-Identifier: MIT
"""Values of a scene as a function of PyTorch, which is not needed for anything else."""
from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Callable, Iterable, Optional, Union

from ._jacobian import columns_of, names_of, places_of

if TYPE_CHECKING:
    from ._scene import Scene


def torch_function(self: "Scene", keys: Union[str, Iterable[str]], points: Any = None, *, elements: Any = None,
                   grid: Union[None, str, int] = None, quantity: Optional[str] = None,
                   threads: int = 0) -> Callable[[Any], Any]:
    """A function of a torch tensor: of the numbers of keys, as jacobian() has its columns, to the values at places.

    Its gradients are those of jacobian(), of which a backward pass is a product with the values' gradient.  Values are
    float64 on the CPU; the result has the type and device of the numbers.  Where there is no derivative, at the border
    of a hard shadow, 0 counts, and where there is no value it is NaN.  ImportError: there is no torch.
    """
    import numpy
    torch: Any = importlib.import_module("torch")

    names = names_of(keys)
    places = None if grid is not None else places_of(self, points, elements, None, False)
    columns = columns_of(self._handle, names)
    wanted = "irradiance" if grid is not None else quantity

    class Values(torch.autograd.Function):  # type: ignore[misc]
        @staticmethod
        def forward(context: Any, numbers: Any) -> Any:
            array = numpy.asarray(numbers.detach().cpu().numpy(), dtype=numpy.float64)
            if array.shape != (len(columns),):
                raise ValueError("a tensor of %d numbers is expected: %s" % (len(columns), ", ".join(columns)))
            scene = self.changed(dict(zip(columns, array.tolist())))
            seen: Any = ({"grid": grid} if places is None else
                         {"points": places} if places.shape[1] == 2 else {"elements": places})
            told = scene.jacobian(names, full=True, quantity=wanted, threads=threads, **seen)
            context.slopes = numpy.nan_to_num(told.derivatives, nan=0.0)
            return torch.as_tensor(told.values, dtype=numbers.dtype, device=numbers.device)

        @staticmethod
        def backward(context: Any, gradient: Any) -> Any:
            pulled = numpy.asarray(gradient.detach().cpu().numpy(), dtype=numpy.float64) @ context.slopes
            return torch.as_tensor(pulled, dtype=gradient.dtype, device=gradient.device)

    def values(numbers: Any) -> Any:
        return Values.apply(numbers)

    return values
