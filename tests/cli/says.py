"""Messages are compared by the facts that they name, not by their wording."""


def first_missing(text, facts):
    """The first of the facts that the text does not name after those before it; None if it names all, in this order."""
    begin = 0
    for fact in facts:
        found = text.find(fact, begin)
        if found < 0:
            return fact
        begin = found + len(fact)
    return None


class Says:
    """For test cases: self.assertSays(done.stderr, "case.toml:3:1: ", "'botom'", "'bottom'")."""

    def assertSays(self, text, *facts):
        if (missing := first_missing(text, facts)) is not None:
            self.fail(f"of {facts} no {missing!r} in: {text}")

    def assertLineSays(self, text, *facts):
        """One of the lines names all of the facts."""
        if not any(first_missing(line, facts) is None for line in text.splitlines()):
            self.fail(f"no line with {facts} in: {text}")
