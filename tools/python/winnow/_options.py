"""Keywords of calls, with signatures and docstrings from the library's tables of options."""

import functools
import inspect
import keyword
import os
import textwrap

from . import _winnow

TABLES = _winnow.tables()


class Option:
    """A row of a table, by the name that it has in Python."""

    def __init__(self, row, name=None):
        self.field, self.takes, self.group, self.help, self.words = row
        if name is None:
            name = self.field + "_" if keyword.iskeyword(self.field) else self.field
        self.name = name

    @property
    def flag(self):
        return not self.takes

    def described(self):
        takes = ", ".join(repr(word) for word in self.words)
        text = self.help + (f" ({takes})" if takes and self.words[0] not in self.help else "")
        indent = {"initial_indent": "        ", "subsequent_indent": "        "}
        return f"    {self.name}:\n" + textwrap.fill(text, 88, **indent)


def options_of(table, leave_out=()):
    return [Option(row) for row in TABLES[table] if row[0] not in leave_out]


def text_of(value, name):
    """The text that the library reads an option's value from."""
    if isinstance(value, str):
        return value
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "item") and getattr(value, "ndim", 1) == 0:
        value = value.item()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, bytes) or not hasattr(value, "__iter__"):
        raise TypeError(f"{name} takes no {type(value).__name__}")
    # Names may have commas in them; nested sequences are a box.
    parts = []
    for part in value:
        if isinstance(part, str):
            part = part.replace("\\", "\\\\").replace(",", "\\,")
        parts.append(text_of(part, name))
    return ",".join(parts) if parts else "none"


def texts_of(options, values):
    """The values that are given, as texts by the names of fields; takes them out of `values`."""
    texts = {}
    for option in options:
        value = values.pop(option.name, None)
        if value is None or (option.flag and value is False):
            continue
        if option.flag and value is not True:
            raise TypeError(f"{option.name} takes True or False, not {value!r}")
        texts[option.field] = text_of(value, option.name)
    return texts


def with_options(table, leave_out=(), context=True):
    """Gives a function the options of a table as keywords, after those that it has.

    It gets them as `options`, and those of speed and memory as `surroundings`, both as texts.
    """
    options = options_of(table, leave_out)
    surroundings = options_of("context") if context else []

    def decorate(function):
        own = inspect.signature(function)
        given_by_us = ("options", "surroundings")
        parameters = [p for p in own.parameters.values() if p.name not in given_by_us]
        for option in options + surroundings:
            parameters.append(
                inspect.Parameter(
                    option.name,
                    inspect.Parameter.KEYWORD_ONLY,
                    default=False if option.flag else None,
                )
            )
        signature = own.replace(parameters=parameters)

        @functools.wraps(function)
        def call(*arguments, **keywords):
            try:
                bound = signature.bind(*arguments, **keywords)
            except TypeError as error:
                raise TypeError(f"{function.__name__}: {error}") from None
            given = dict(bound.arguments)
            texts = texts_of(options, given)
            around = texts_of(surroundings, given)
            return function(**given, options=texts, surroundings=around)

        call.__signature__ = signature
        call.__doc__ = documented(function.__doc__, options + surroundings)
        return call

    return decorate


def documented(text, options):
    """A docstring with a line for each option, under their headings."""
    lines = [inspect.cleandoc(text or "")]
    group = ""
    for option in options:
        if option.group != group or len(lines) == 1:
            group = option.group
            lines.append(f"\n{group or 'Options'}:")
        lines.append(option.described())
    return "\n".join(lines) + "\n"
