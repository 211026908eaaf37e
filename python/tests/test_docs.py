"""Every example in a docstring does what it says."""

import doctest
import importlib
import inspect
import pkgutil

import numpy as np
import pytest

import vides

MODULES = ["vides", *(f"vides.{m.name}" for m in pkgutil.iter_modules(vides.__path__) if m.name != "_vides")]


NAMES = {**{key: getattr(vides, key) for key in vides.__all__}, "np": np}
CLASSES = [key for key in vides.__all__ if inspect.isclass(NAMES[key])]


@pytest.mark.parametrize("name", MODULES)
def test_examples(name: str) -> None:
    done = doctest.testmod(importlib.import_module(name), extraglobs=NAMES)
    assert done.failed == 0


@pytest.mark.parametrize("name", CLASSES)
def test_examples_of_classes(name: str) -> None:
    """A module does not find what says that it is of ``vides``."""
    finder, runner = doctest.DocTestFinder(), doctest.DocTestRunner()
    for kind in inspect.getmro(NAMES[name]):
        if kind.__module__.split(".")[0] == "vides":
            for found in finder.find(kind, name, module=False, globs=dict(NAMES)):
                assert runner.run(found).failed == 0
    assert runner.summarize().attempted > 0 or name not in ("Path", "Point", "Scene", "Samples")


def test_names_are_those_by_which_people_reach_things() -> None:
    for name in CLASSES:
        assert NAMES[name].__module__ == "vides" and repr(NAMES[name]) == f"<class 'vides.{name}'>"
    for base in vides.Path.__mro__[:-2]:
        for member in vars(base).values():
            private = getattr(member, "__func__", member)
            if inspect.isfunction(private):
                assert private.__qualname__.startswith("Path."), private
    with pytest.raises(TypeError, match=r"^Path\.retime\(\) got an unexpected keyword"):
        vides.Path().retime(speeds=1)  # type: ignore[call-arg]
