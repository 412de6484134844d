"""Networks as the benchmark hands them over: steps that refer to earlier ones by their numbers."""


def harmonic(a, b):
    return 1 / (1 / a + 1 / b)


def composed(steps, element, series=harmonic):
    """The last step's value. element(kind, name...) gives that of a spring, a damper or a Maxwell branch."""
    values = []
    for kind, *rest in steps:
        if kind == "parallel":
            values.append(values[rest[0]] + values[rest[1]])
        elif kind == "series":
            values.append(series(values[rest[0]], values[rest[1]]))
        elif kind == "mesh":
            values.append(values[rest[0]] * values[rest[1]] / values[rest[2]])
        else:
            values.append(element(kind, *rest))
    return values[-1]
