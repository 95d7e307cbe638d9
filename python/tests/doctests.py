"""Runs the examples in the docstrings of the module, in the names of a program that has imported all of it."""

import doctest
import importlib
import pkgutil
import sys

import steplab

names = {name: getattr(steplab, name) for name in steplab.__all__}
modules = [steplab] + [
    importlib.import_module(f"steplab.{module.name}")
    for module in pkgutil.iter_modules(steplab.__path__)
    if module.name != "_core"
]
results = [doctest.testmod(module, extraglobs=names) for module in modules]
examples = sum(result.attempted for result in results)
print(f"{examples} examples")
sys.exit(any(result.failed for result in results) or examples < 20)
