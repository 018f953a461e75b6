"""Lets pip build the module by CMake; pyproject.toml says the rest.

CMAKE_ARGS in the environment are more arguments for CMake. WINNOW_BUILD is a folder that is built
by it already, with -DWINNOW_PYTHON=ON.
"""

import os
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        build = os.environ.get("WINNOW_BUILD")
        if not build:
            build = os.path.abspath(os.path.join(self.build_temp, "cmake"))
            self.build_module(build)
        target = os.path.dirname(os.path.abspath(self.get_ext_fullpath(extension.name)))
        os.makedirs(target, exist_ok=True)
        for name in os.listdir(os.path.join(build, "python", "winnow")):
            if name.startswith("_winnow.") or name.endswith(".pyi"):
                shutil.copy(os.path.join(build, "python", "winnow", name), target)

    def build_module(self, build):
        source = os.path.dirname(os.path.abspath(__file__))
        left_out = ["CLI", "TESTS", "GENERATE"]
        subprocess.run(
            ["cmake", "-S", source, "-B", build, "-DCMAKE_BUILD_TYPE=Release"]
            + ["-DWINNOW_PYTHON=ON", "-DWINNOW_UNITY=ON", f"-DPython_EXECUTABLE={sys.executable}"]
            + [f"-DWINNOW_{part}=OFF" for part in left_out]
            + os.environ.get("CMAKE_ARGS", "").split(),
            check=True,
        )
        command = ["cmake", "--build", build, "--parallel", "--target", "winnow_python"]
        subprocess.run(command, check=True)


setup(ext_modules=[Extension("winnow._winnow", [])], cmdclass={"build_ext": BuildByCMake})
