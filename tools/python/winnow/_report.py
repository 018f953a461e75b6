"""Reports, with their fields as attributes."""


class Report(dict):
    """What a call did: the fields of the program's `--json`, as a dict and as attributes.

    >>> report = Report({"output": {"faces": 12}})
    >>> report.output.faces
    12
    """

    def __init__(self, fields):
        super().__init__(
            (name, Report(value) if isinstance(value, dict) else value)
            for name, value in fields.items()
        )

    def __getattr__(self, name):
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"the report has no '{name}'") from None

    def __dir__(self):
        return [*super().__dir__(), *self]
