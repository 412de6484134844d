"""Eq. (24) derived for a scene, as `vcrit derive` does it."""

import json
from functools import cached_property
from typing import Any, NamedTuple

from . import _vcrit
from .inputs import characters, flag, refused
from .scene import Scene


class Equation(NamedTuple):
    """left = right, in two notations."""

    words: str
    """What it says or how it follows; may be empty."""
    text: str
    latex: str

    def _repr_latex_(self) -> str:
        return _displayed([self.latex])


class Limit(NamedTuple):
    """A limit or special case of v* that the scene has."""

    name: str
    """"kd -> infinity", say."""
    equation: str
    """Its number in the paper, where it has one, else empty."""
    text: str
    """v* in the limit."""
    latex: str
    definitions: tuple[Equation, ...]
    """Definitions of the names in it that are not symbols of the scene."""

    def _repr_latex_(self) -> str:
        return _displayed([each.latex for each in self.definitions] + ["v^{*} = " + self.latex])


class Derivation:
    """The formula of v* for one scene; a notebook shows it. Made by `derive`."""

    def __init__(self, scene: Scene, form: str) -> None:
        self._scene, self._form = scene, form
        self._found: dict[str, Any] = json.loads(self.document("json"))

    @property
    def text(self) -> str:
        """The whole derivation, step by step: what `vcrit derive SCENE` prints."""
        return self.document("text")

    @property
    def latex(self) -> str:
        """The result, "v^{*} = ..."."""
        return str(self._found["lines"][-1]["latex"])

    @property
    def formula(self) -> str:
        """The result's right-hand side as text, "mu0*omega*du_z*..."."""
        return str(self._found["critical_velocity"]["text"])

    @property
    def equation(self) -> str:
        """The result's number in the paper: "(24)", or that of a special case."""
        return str(self._found["equation"])

    @property
    def parameters(self) -> tuple[str, ...]:
        """The symbols that v* depends on, and no others."""
        return tuple(self._found["parameters"])

    @property
    def fingerprint(self) -> str:
        """The same for two scenes if and only if they have the same formula."""
        return str(self._found["fingerprint"])

    @property
    def lines(self) -> tuple[Equation, ...]:
        """The steps, from the equations of motion to the result."""
        return _equations(self._found["lines"])

    @property
    def definitions(self) -> tuple[Equation, ...]:
        """Definitions of the names in the result that are not symbols of the scene, each by earlier ones."""
        return _equations(self._found["definitions"])

    @cached_property
    def limits(self) -> tuple[Limit, ...]:
        """The limits and special cases that the scene has; derived when first asked for."""
        found = json.loads(self.document("json", limits=True))["limits"]
        return tuple(
            Limit(each["name"], each["equation"], each["text"], each["latex"],
                  _equations(each["definitions"]))
            for each in found)

    def document(self, format: str = "text", *, limits: bool = False,
                 sensitivities: bool = False, standalone: bool = False) -> str:
        """What `vcrit derive SCENE --format FORMAT [--limits] [--sensitivities] [--standalone]` prints.

        format: "text", "latex", "markdown", "html" or "json", or that of a system, which has v* alone: "sympy",
        "mathematica", "maple", "maxima", "mathml" or "c".
        """
        return _vcrit.document(self._scene._handle, characters(format, "format"), self._form,
                               flag(limits, "limits"), flag(sensitivities, "sensitivities"),
                               flag(standalone, "standalone"))

    def _repr_latex_(self) -> str:
        return _displayed([each.latex for each in self.definitions] + [self.latex])

    def __repr__(self) -> str:
        return f"v* = {self.formula}"


def derive(scene: Scene, *, form: str = "shortest") -> Derivation:
    """Derives the formula of v* for `scene`, whose elements need no values.

    form: "shortest", "nested", "storage-loss", "rational", "dimensionless" or "expanded", as `vcrit derive --form`.
    Raises ModelError where the rational or the expanded form is too large.
    """
    if not isinstance(scene, Scene):
        raise refused("scene", f"a {type(scene).__name__}", "a vcrit.Scene, as vcrit.Scene(file)")
    return Derivation(scene, characters(form, "form"))


def _equations(lines: list[dict[str, str]]) -> tuple[Equation, ...]:
    return tuple(Equation(line["words"], line["text"], line["latex"]) for line in lines)


def _displayed(lines: list[str]) -> str:
    """A displayed formula for a notebook."""
    if len(lines) == 1:
        return f"$\\displaystyle {lines[0]}$"
    return "$$\\begin{gathered}\n" + " \\\\\n".join(lines) + "\n\\end{gathered}$$"
