"""What `vcrit check` says of who answers, against who does."""

import json

from cells import LOOKED_AT, refusal, run, scene

# The columns of commands by which `check` is tried.
CHECKED = {"derive": "derive/shortest/text", "generate": "generate/c++", "simulate": "simulate/exact", "plot": "plot/friction",
           "sweep": "sweep/critical_velocity", "solve": "solve/amplitude"}
# What is refused by the numbers of a scene, which the rulebook does not know: (kind, column) and status.
BY_NUMBERS = {("antiresonance", "solve/amplitude"): "3", ("resonance", "solve/amplitude"): "3", ("resonance", "critical"): "3",
              ("near_resonance", "critical"): "3"}


def check(case, kind, column):
    """Who answers by the rulebook, against who does, by refusals.csv."""
    LOOKED_AT.add((kind, column))
    ran = run("check", scene(kind), "--json")
    (told,) = json.loads(ran.stdout)["scenes"]
    case.assertEqual([problem for problem in told["problems"] if problem["kind"] == "error"], [])
    case.assertEqual(ran.returncode, 3 if told["outside_the_model"] else 0)
    for each in told["commands"]:
        asked = CHECKED.get(each["command"], each["command"])
        status, _ = refusal(kind, asked) or ("0", "")
        if each["answers"]:
            case.assertEqual(status, BY_NUMBERS.get((kind, asked), "0"), asked)
        else:
            case.assertIn(status, ("2", "3"), f"{asked} {each}")
