#!/usr/bin/env python3
"""Fails if a file includes a layer, or a third-party library, its own layer may not.

The only source of truth is docs/architecture/layers.txt, which lists layers so
that each may include only layers above it: the order in the file is the proof
that the arrows have no cycle. "*" means every layer; no layer may list one that
has "*", so programs and tests are included by nothing. A source includes the
header of its own name first, which shows that the header compiles alone, and
declares no names of others that it does not use.
usage: check_layers.py REPOSITORY_ROOT
"""
import pathlib
import re
import sys

OURS = re.compile(r'^\s*#\s*include\s*"([^"]+)"')
SYSTEM = re.compile(r'^\s*#\s*include\s*<([^>]+)>')
USING = re.compile(r"^\s*(?:using\s+(?:\w+::)+(\w+);|namespace\s+(\w+)\s*=\s*[\w:]+;)", re.M)
SCRIPT = re.compile(r"""^(?:(?:import|export)\b|\}\s*from\b).*["']([^"'.][^"']*)["'];?\s*$""")
NEVER = re.compile("(?!)")  # scripts include no layer
SCRIPTS = {".js", ".mjs"}
SUFFIXES = {".hpp", ".cpp"} | SCRIPTS
THIRD_PARTY = {"nauty": r"nauty|naugroup|nausparse|gtools|traces", "omp": r"omp\.h", "mpi": r"mpi\.h",
               "gmp": r"gmp", "CGAL": r"CGAL/", "z3": r"z3", "Eigen": r"Eigen/", "cadical": r"cadical|ccadical",
               "sqlite": r"sqlite3", "zstd": r"zstd", "zlib": r"zlib\.h", "pugixml": r"pugixml", "openssl": r"openssl/",
               "json": r"nlohmann/", "cli11": r"CLI/", "fmt": r"fmt/", "boost": r"boost/",
               "three": r"three\b", "spdlog": r"spdlog/", "pybind": r"pybind11/|nanobind/|Python\.h", "gtest": r"g(test|mock)/",
               "rapidcheck": r"rapidcheck", "benchmark": r"benchmark/"}


def read_layers(path):
    rows = (line.split("|") for line in path.read_text().splitlines() if line.strip() and line[0] != "#")
    return {name.strip(): (set(ours.split()), set(theirs.split())) for name, ours, theirs in rows}


def disorder(layers):
    above = set()
    for name, (may_include, may_use) in layers.items():
        for target in sorted(may_include - above - {"*"}):
            yield f"layers.txt: {name} lists {target}, which is not above it"
        for target in sorted(t for t in may_include & above if "*" in layers[t][0]):
            yield f"layers.txt: {name} lists {target}, which is a program"
        for library in sorted(may_use - THIRD_PARTY.keys()):
            yield f"layers.txt: {name} uses {library}, which check_layers.py does not know"
        above.add(name)


def layer_of(path, layers):
    """Longest layer name that is a path prefix, or None."""
    owners = [name for name in layers if path == name or path.startswith(name + "/")]
    return max(owners, key=len, default=None)


def sources(root, layers):
    """C++ and JavaScript files below the top-level folders of layers.txt; build trees lie elsewhere."""
    tops = sorted({name.split("/")[0] for name in layers})
    return [p for top in tops for p in sorted((root / top).rglob("*")) if p.suffix in SUFFIXES]


def violations(root, layers):
    for file in sources(root, layers):
        name = file.relative_to(root).as_posix()
        layer = layer_of(name, layers)
        if layer is None:
            yield f"{name}:1: file belongs to no layer"
            continue
        may_include, may_use = layers[layer]
        ours_of, system_of = (NEVER, SCRIPT) if file.suffix in SCRIPTS else (OURS, SYSTEM)
        for number, line in enumerate(file.read_text().splitlines(), start=1):
            if ours := ours_of.match(line):
                target = layer_of(ours[1], layers)
                if target is None:
                    yield f'{name}:{number}: "{ours[1]}" is not a path from the repository root'
                elif target == layer or target in may_include:
                    continue
                elif "*" not in may_include or "*" in layers[target][0]:
                    yield f"{name}:{number}: {layer} must not include {target}"
            elif system := system_of.match(line):
                for library, pattern in THIRD_PARTY.items():
                    if re.match(pattern, system[1]) and library not in may_use:
                        yield f"{name}:{number}: {layer} must not use {library}"


def hidden_needs(root, layers):
    """A header that its source includes first is compiled alone there. What comes before it in the
    doors of third-party libraries is of these libraries."""
    for source in (p for p in sources(root, layers) if p.suffix == ".cpp"):
        own = source.relative_to(root).with_suffix(".hpp").as_posix()
        if not (root / own).exists():
            continue
        first = next((m[1] for m in map(OURS.match, source.read_text().splitlines()) if m), None)
        if first != own:
            yield f'{source.relative_to(root).as_posix()}:1: the first file of ours to include is "{own}"'


def unused_names(root, layers):
    """clang-tidy sees these in the file alone that it is called for, not in those compiled with it."""
    for source in (p for p in sources(root, layers) if p.suffix == ".cpp"):
        text = source.read_text()
        for use in USING.finditer(text):
            name = use[1] or use[2]
            if len(re.findall(rf"\b{name}\b", text[:use.start()] + text[use.end():])) == 0:
                line = text.count("\n", 0, use.start(1 if use[1] else 2)) + 1
                yield f"{source.relative_to(root).as_posix()}:{line}: {name} is declared here and not used"


def main():
    root = pathlib.Path(sys.argv[1])
    layers = read_layers(root / "docs/architecture/layers.txt")
    found = list(disorder(layers)) + list(violations(root, layers)) \
        + list(hidden_needs(root, layers)) + list(unused_names(root, layers))
    if not sources(root, layers):
        found.append(f"layers: no source file below {root}; a gate that sees nothing proves nothing")
    print("\n".join(found) or f"layers: no violation in {len(sources(root, layers))} files")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
