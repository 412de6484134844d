"""Scenes of few words: what a test says of one, and the rest as usual."""

import json

SECTIONS = {
    "contact": ["normal", "tangential", "poisson", "tangential_ratio", "separation"],
    "indenter": ["shape", "radius", "angle", "prefactor", "exponent"],
    "drive": ["network", "receptance"],
    "body": ["mass"],
    "oscillation": ["frequency", "angular_frequency", "amplitude", "indentation"],
    "friction": ["coefficient"],
}
USUAL = {"normal": "kn", "amplitude": 0.1, "indentation": 1, "coefficient": 0.3}


def section(name, values):
    # A value of JSON is one of TOML.
    lines = "".join(f"{key} = {json.dumps(value, ensure_ascii=False)}\n" for key, value in values.items())
    return f"[{name}]\n{lines}" if lines else ""


def scene(elements=(), networks=(), **changed):
    """The text of a scene of few words: keys as in the file, each put into its section; None leaves one out. Numbers
    stay as they are, texts are quoted. `networks`: expressions, and graphs as (terminals, edges)."""
    given = dict(USUAL)
    if not {"tangential", "tangential_ratio"} & set(changed):
        given["poisson"] = 0.3
    if "frequency" not in changed:
        given["angular_frequency"] = 2
    given |= changed
    unknown = set(given) - {key for keys in SECTIONS.values() for key in keys}
    if unknown:
        raise KeyError(f"{unknown} in no section; write them into the text")
    text = "".join(section(name, {key: given[key] for key in keys if given.get(key) is not None})
                   for name, keys in SECTIONS.items())
    graphs = {name: each for name, each in dict(networks).items() if not isinstance(each, str)}
    text += section("elements", dict(elements))
    text += section("networks", {name: each for name, each in dict(networks).items() if name not in graphs})
    return text + "".join(section(f"networks.{name}", {"terminals": terminals, "edges": edges})
                          for name, (terminals, edges) in graphs.items())
