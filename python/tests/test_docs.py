"""Every example in a docstring does what it says."""

import doctest
import importlib
import pkgutil

import numpy as np
import pytest

import vides

MODULES = ["vides", *(f"vides.{m.name}" for m in pkgutil.iter_modules(vides.__path__) if m.name != "_vides")]


@pytest.mark.parametrize("name", MODULES)
def test_examples(name: str) -> None:
    names = {key: getattr(vides, key) for key in vides.__all__}
    done = doctest.testmod(importlib.import_module(name), extraglobs={**names, "np": np})
    assert done.failed == 0
