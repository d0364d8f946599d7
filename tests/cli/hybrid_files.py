"""A mesh of one cell of each shape: a cube, on it a prism as a roof, beside it a pyramid, and on one facet
of this a tetrahedron; lattices of cubes cut into tetrahedra; and writers of such meshes in each format."""
import itertools

POINTS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1),
          (0, 0.5, 1.5), (1, 0.5, 1.5), (2, 0.5, 0.5), (2, -1, 0.5)]
HEXAHEDRON = (0, 1, 2, 3, 4, 5, 6, 7)
PRISM = (4, 7, 8, 5, 6, 9)  # the roof: a triangle at x = 0 and one at x = 1
PYRAMID = (1, 2, 6, 5, 10)
TETRAHEDRON = (1, 10, 5, 11)
CELLS = [TETRAHEDRON, HEXAHEDRON, PRISM, PYRAMID]
# The same solid of tetrahedra: the cube in six, the roof in three, the pyramid in two.
GIVEN = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6),
         (4, 6, 7, 8), (4, 5, 6, 8), (5, 6, 8, 9), (1, 2, 6, 10), (1, 6, 5, 10), TETRAHEDRON]
VTK = {4: 10, 8: 12, 6: 13, 5: 14}
GMSH = {4: 4, 8: 5, 6: 6, 5: 7}
MEDIT = {4: "Tetrahedra", 8: "Hexahedra", 6: "Prisms", 5: "Pyramids"}


def kuhn(n):
    """The unit cube as n^3 cubes, each cut into six tetrahedra around its diagonal."""
    points = [(i / n, j / n, k / n) for i in range(n + 1) for j in range(n + 1) for k in range(n + 1)]
    number = {p: i for i, p in enumerate(itertools.product(range(n + 1), repeat=3))}
    cells = []
    for cube in itertools.product(range(n), repeat=3):
        for axes in itertools.permutations(range(3)):
            at = list(cube)
            cell = [number[tuple(at)]]
            for axis in axes:
                at[axis] += 1
                cell.append(number[tuple(at)])
            if sum(a > b for a, b in itertools.combinations(axes, 2)) % 2:
                cell[2], cell[3] = cell[3], cell[2]
            cells.append(cell)
    return points, cells


def in_vtk_order(cell):
    return tuple(cell[i] for i in (0, 2, 1, 3, 5, 4)) if len(cell) == 6 else cell


def words(numbers, base=0):
    return " ".join(str(n + base) for n in numbers)


def vtk(points, cells):
    cells = [in_vtk_order(c) for c in cells]
    return ("# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\n"
            f"POINTS {len(points)} double\n" + "".join(words(p) + "\n" for p in points) +
            f"CELLS {len(cells)} {sum(len(c) + 1 for c in cells)}\n" +
            "".join(f"{len(c)} {words(c)}\n" for c in cells) +
            f"CELL_TYPES {len(cells)}\n" + "".join(f"{VTK[len(c)]}\n" for c in cells))


def vtu(points, cells):
    cells = [in_vtk_order(c) for c in cells]
    ends = [sum(len(c) for c in cells[:i + 1]) for i in range(len(cells))]
    array = '<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="ascii">{}</DataArray>\n'
    return ('<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian">\n'
            f'<UnstructuredGrid><Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}">\n<Points>' +
            array.format("Float64", "Points", 3, " ".join(map(words, points))) + "</Points>\n<Cells>" +
            array.format("Int64", "connectivity", 1, " ".join(map(words, cells))) +
            array.format("Int64", "offsets", 1, words(ends)) +
            array.format("UInt8", "types", 1, words(VTK[len(c)] for c in cells)) +
            '</Cells></Piece></UnstructuredGrid></VTKFile>\n')


def medit(points, cells):
    text = f"MeshVersionFormatted 2\nDimension 3\nVertices {len(points)}\n" + "".join(words(p) + " 0\n" for p in points)
    for size, name in MEDIT.items():
        rows = [c for c in cells if len(c) == size]
        if rows:
            text += f"{name} {len(rows)}\n" + "".join(words(c, 1) + " 0\n" for c in rows)
    return text + "End\n"


def gmsh(points, cells):
    return ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + f"{len(points)}\n" +
            "".join(f"{i + 1} {words(p)}\n" for i, p in enumerate(points)) + "$EndNodes\n$Elements\n" +
            f"{len(cells)}\n" + "".join(f"{i + 1} {GMSH[len(c)]} 2 0 1 {words(c, 1)}\n" for i, c in enumerate(cells)) +
            "$EndElements\n")


WRITERS = {"vtk": vtk, "vtu": vtu, "mesh": medit, "msh": gmsh}
