"""creepcontact: creep of machine parts in contact.

    import creepcontact as cc
    model = cc.Model("press_fit.toml", set={"contacts[0].gap": -0.06})
    run = model.run()
    run.history["fit_pressure"], run.fields()["von_mises"]
"""

import os as _os

# Libraries read these as they are loaded: waiting threads sleep, and the BLAS makes none before it factors.
if "GOMP_SPINCOUNT" not in _os.environ:
    _os.environ.setdefault("OMP_WAIT_POLICY", "passive")
_os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from ._core import version as __version__  # noqa: E402: after the settings
from .errors import ConfigError, Error, Mistake, ModelError, SolverError  # noqa: E402
from ._materials import CreepCurve, Fit, Material, fit, law, laws, material, materials  # noqa: E402
from .model import Model, State  # noqa: E402
from .results import Fields, Mesh, Run, Table, open  # noqa: A004, E402

__all__ = ["ConfigError", "CreepCurve", "Error", "Fields", "Fit", "Material", "Mesh", "Mistake", "Model", "ModelError", "Run",
           "SolverError", "State", "Table", "__version__", "fit", "law", "laws", "material", "materials", "open"]
