"""What `vcrit check` says of who answers, against who does; what `eval` says of the normal motion."""

import json

from cells import LOOKED_AT, REFERENCES, U, refusal, run, scene

# The columns of commands by which `check` is tried.
CHECKED = {"derive": "derive/shortest/text", "generate": "generate/c++", "simulate": "simulate/exact", "plot": "plot/speed",
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


def normal(case, kind, answer):
    """What a load presses, and what a mount leaves of the vibration; keys that others do not have."""
    references = REFERENCES[kind]
    for key, name, allowed in (("amplitude", "normal_oscillation:amplitude", 8 * U), ("mount_phase", "normal_oscillation:phase", 8 * U),
                               ("sinking_velocity", "sinking_velocity", 2 * U)):
        case.assertEqual(key in answer, name in references and not answer.get("opens"), key)
        if key in answer:
            case.near(answer[key], references(name), allowed * abs(float(references(name))), key)
    pressed = "value:W" in references or "value:U" in references
    case.assertEqual("mean_normal_force" in answer, pressed)
    case.assertEqual("indentation" in answer, pressed and "sinking_velocity" not in references)
    for key in ("indentation", "mean_normal_force"):
        if key in answer:
            case.near_pressed(kind, None, key, answer[key])
