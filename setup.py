"""`pip install .`: CMake builds the extension module and the programs that it starts; the rest is in pyproject.toml."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent
VERSION = re.search(r"project\(creepcontact VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


class CMakeBuild(build_ext):
    def run(self):
        build = ROOT / "build" / "pip"
        subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-D", "CMAKE_BUILD_TYPE=Release", "-D", "CREEPCONTACT_TESTS=OFF",
                        "-D", "CREEPCONTACT_MPI=OFF", "-D", f"Python3_EXECUTABLE={sys.executable}"], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "creepcontact_python", "creepcontact_mesher", "creepcontact_optimizer"],
                       check=True)
        package = (ROOT / "python" if self.inplace else Path(self.build_lib)) / "creepcontact"
        package.mkdir(parents=True, exist_ok=True)
        module, = (build / "python/creepcontact").glob("_core.*.so")
        for file in (module, build / "bin/creepcontact-mesher", build / "bin/creepcontact-optimizer.so"):
            shutil.copy(file, package)
        shutil.copytree(ROOT / "materials", package / "materials", dirs_exist_ok=True)


setup(version=VERSION, ext_modules=[Extension("creepcontact._core", sources=[])], cmdclass={"build_ext": CMakeBuild})
