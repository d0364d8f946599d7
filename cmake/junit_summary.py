#!/usr/bin/env python3
"""Adds up JUnit reports: names the failing tests, ends with "N passed, N failed[, N skipped]".

usage: junit_summary.py FILE_OR_FOLDER...
Exit status 1 if a test failed, if none ran, or if a report cannot be read.

A test that CTest could not start (no executable, a failed fixture) is reported by it as skipped;
here it is failed. Skipped are tests that said so themselves, and disabled ones. A program that CTest
reports as one test, which passed, counts as the tests in its own report, NAME.xml beside that of CTest.
"""
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

CHOSEN = ("SKIP_RETURN_CODE", "SKIP_REGULAR_EXPRESSION", "Disabled")


def outcome(case):
    if case.find("failure") is not None or case.find("error") is not None or case.get("status") == "fail":
        return "failed"
    skipped = case.find("skipped")
    if skipped is not None or case.get("status") in ("notrun", "disabled"):
        reason = "" if skipped is None else skipped.get("message", "")
        # GoogleTest has a result, CTest has none.
        chosen = case.get("status") == "disabled" or reason.startswith(CHOSEN) or (
            case.get("result") in ("skipped", "suppressed"))
        return "skipped" if chosen else "failed"
    return "passed"


def reports(arguments):
    for path in map(pathlib.Path, arguments):
        yield from sorted(path.glob("*.xml")) if path.is_dir() else [path]


def name_of(case):
    name, of = case.get("name", "unnamed"), case.get("classname")
    return name if of in (None, "", name) else f"{of}.{name}"


def cases(path):
    """Pairs (name, outcome); an unreadable report is one failed test."""
    try:
        for case in ElementTree.parse(path).iter("testcase"):
            name, result = name_of(case), outcome(case)
            if result != "passed" or not (path.parent / f"{name}.xml").exists():
                yield name, result
    except (ElementTree.ParseError, OSError) as error:
        yield f"report cannot be read: {error}", "failed"


def main(arguments):
    count = {"passed": 0, "failed": 0, "skipped": 0}
    for path in reports(arguments):
        for name, result in cases(path):
            count[result] += 1
            if result != "passed":
                print(f"{result}: {path.stem}: {name}")
    ran = count["passed"] + count["failed"]
    skipped = f", {count['skipped']} skipped" if count["skipped"] else ""
    print(f"{count['passed']} passed, {count['failed']} failed{skipped}")
    return 0 if ran > 0 and count["failed"] == 0 else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
