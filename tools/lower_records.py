"""Lower records to offsets: from kernel modules with records to the same modules without,
before anything is translated.

    region.spacing                work[region + REGION_SPACING]
    region.first                  int(work[region + REGION_FIRST])             where the field is an int
    work.regions[i].low           work[WORK_REGIONS + REGION_SIZE * i + REGION_LOW]
    region = work.regions[i]      region = WORK_REGIONS + REGION_SIZE * i
    frame.raised                  work[WORK_FRAME + FRAME_RAISED]              there is only one Frame
    def f(frame: Frame, region: Region, x: float)     def f(work: 'float[:]', region: int, x: float)
    def f(...) -> Region                              def f(...) -> int
    def f(...) without a result                       the same with ``return 0`` at its end
    f(work.frame, work.regions[0], y)                 f(work, WORK_REGIONS, y)
    copy(region, to)              for i_1 in range(REGION_SIZE): work[to + i_1] = work[region + i_1]
    clear(region)                 for i_2 in range(REGION_SIZE): work[region + i_2] = 0.0

The classes of the room layout (record_layout.py) say where each field is and in which array each record
lives; those with ``array = "..."`` are that array's head. What is not a field, and a record of another
class than the one asked for, is refused with its line.
"""

import ast
import re
from collections import namedtuple
from copy import deepcopy
from ctypes import sizeof

from record_layout import Layout, Refused, constant, is_record, is_root, is_run

#: Marks for the C compiler (layout/record.py).
MARKS = {"inlined", "native", "seldom"}
#: Results that are no record.
NUMBERS = ("bool", "float", "int")
#: Words of the dialect that become something else.
WORDS = {"clear", "copy", "offset"}
#: Arrays in which records live, in the order in which a function gets them.
ARRAYS = ("setup", "tables", "work", "state", "report")
#: What has been lowered in this process, by module, text and all that it follows from: copies with one error
#: each are lowered in a run.
KNOWN = {}
# records, or numbers, at the sum of ``terms`` in ``array``
Ref = namedtuple("Ref", "kind array terms")


def total(terms):
    """The sum of names, numbers and expressions as an expression."""
    nodes = [ast.Name(term, ast.Load()) if isinstance(term, str) else term for term in terms] or [
        ast.Constant(0)
    ]
    result = nodes[0]
    for node in nodes[1:]:
        result = ast.BinOp(result, ast.Add(), node)
    return result


def distance(part, whole):
    """How far behind the beginning of the record ``whole`` another begins; None is an array."""
    terms = whole.terms if whole else []
    return ast.BinOp(total(part.terms), ast.Sub(), total(terms)) if terms else total(part.terms)


class Lowered(ast.NodeTransformer):
    """One module. ``signatures`` of all modules: {(module, function): [(parameter, record class or None)]},
    and ``results``: the class of the record that a function returns."""

    def __init__(self, name, text, layout, signatures, results):
        self.name, self.layout, self.signatures, self.results = name, layout, signatures, results
        self.lines = text.split(b"\n")
        self.tree = ast.parse(text)
        self.origins = {
            alias.name: node.module
            for node in self.tree.body
            if isinstance(node, ast.ImportFrom)
            for alias in node.names
        }
        self.edits, self.records = [], {}
        for node in self.tree.body:
            if isinstance(node, ast.FunctionDef):
                self.function(node)
        self.imports()

    def refuse(self, node, why):
        raise Refused(f"{self.name}.py, line {node.lineno}: {why}")

    # --- functions ------------------------------------------------------------------------------------

    def function(self, node):
        for mark in node.decorator_list:
            self.edits.append(((mark.lineno, 0), (mark.end_lineno, mark.end_col_offset), ""))
        parameters = record_parameters(node, self.layout)
        self.records, self.loops = {}, 0
        self.assigned = [
            n.id for n in ast.walk(node) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)
        ]
        for name, kind in parameters:
            if is_root(kind):
                self.records[name] = Ref(kind, name, [])
        for name, kind in parameters:
            if kind and not is_root(kind):
                array, terms = self.layout.home(kind)
                self.records[name] = Ref(kind, self.array_name(array), [name] if terms is None else terms)
        if any(kind for _, kind in parameters):
            annotations = {a.arg: ast.unparse(a.annotation) for a in node.args.args}
            texts = [f"{array}: 'float[:]'" for array in added_arrays(parameters, self.layout)]
            for name, kind in parameters:
                if kind is None:
                    texts.append(f"{name}: {annotations[name]}")
                elif is_root(kind):
                    texts.append(f"{name}: 'float[:]'")
                elif self.layout.home(kind)[1] is None:
                    texts.append(f"{name}: int")
            first, last = node.args.args[0], node.args.args[-1].annotation
            self.edit(first, last, ", ".join(texts))
        if node.returns:
            self.result(node)
        self.block(node.body)
        self.end(node)

    def result(self, node):
        """A record that a function returns is its offset; numbers and truths follow from what it returns."""
        if node.returns.id not in NUMBERS:
            self.edit(node.returns, node.returns, "int")
            return
        line = self.lines[node.returns.lineno - 1]
        start = line[: node.returns.col_offset].rindex(b"->")
        self.edits.append(
            (
                (node.returns.lineno, len(line[:start].rstrip())),
                (node.returns.end_lineno, node.returns.end_col_offset),
                "",
            )
        )

    def end(self, node):
        """A function without a result returns 0, as C and the differentiation have it; the line is that
        below its last one, which is empty."""
        if any(part.value for part in ast.walk(node) if isinstance(part, ast.Return)):
            return
        for part in ast.walk(node):
            if isinstance(part, ast.Return):
                self.edit(part, part, "return 0")
        if not isinstance(node.body[-1], ast.Return):
            self.lines += [b""] * (node.end_lineno + 1 - len(self.lines))
            place = node.end_lineno + 1, 0
            self.edits.append((place, place, "    return 0"))

    def array_name(self, array):
        """What this function calls an array: its parameter of the class at that array's head,
        or the array's own name."""
        return next(
            (
                name
                for name, ref in self.records.items()
                if is_root(ref.kind) and ref.kind.array == array and not ref.terms
            ),
            array,
        )

    def block(self, statements):
        for node in statements:
            if isinstance(node, (ast.If, ast.While)):
                self.replace(node.test)
            elif isinstance(node, ast.For):
                self.replace(node.iter)
            elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name) and self.note(node):
                continue
            elif (
                isinstance(node, ast.Return)
                and isinstance(node.value, ast.Name)
                and node.value.id in self.records
            ):
                self.edit(node.value, node.value, ast.unparse(total(self.records[node.value.id].terms)))
            elif isinstance(node, ast.Expr) and ast.unparse(node).startswith(("copy(", "clear(")):
                self.edit(node, node, self.loop(node.value))
            elif isinstance(node, (ast.Assign, ast.AugAssign, ast.Return, ast.Expr)):
                self.replace(node)
            for body in (getattr(node, "body", []), getattr(node, "orelse", [])):
                self.block(body)

    def loop(self, call):
        """``copy`` or ``clear`` as a loop over all numbers, in one line."""
        refs = [self.ref(argument) for argument in call.args]
        sizes = {ref and (is_record(ref.kind) or is_run(ref.kind)) and sizeof(ref.kind) for ref in refs}
        if not all(sizes) or len(sizes) > 1:
            self.refuse(call, f"{ast.unparse(call)}: no records of one size")
        self.loops += 1
        places = [f"{ref.array}[{ast.unparse(total([*ref.terms, f'i_{self.loops}']))}]" for ref in refs]
        return f"for i_{self.loops} in range({ast.unparse(numbers(refs[0].kind))}): {places[-1]} = " + (
            places[0] if len(places) == 2 else "0.0"
        )

    def note(self, node):
        """A record under a local name: an offset, or nothing at all where it has only one place."""
        name, ref = node.targets[0].id, self.ref(node.value)
        if ref is None or not (is_record(ref.kind) or is_run(ref.kind)):
            return False
        if self.assigned.count(name) == 1 and all(
            isinstance(term, str) and term.isupper() for term in ref.terms
        ):
            self.records[name] = ref
            self.edit(node, node, "")
            return True
        known = self.records.get(name)
        if known and (known.kind, known.array) != (ref.kind, ref.array):
            self.refuse(node, f"{name} is a {known.kind.__name__} before")
        self.records[name] = Ref(ref.kind, ref.array, [name])
        self.edit(node, node, f"{name} = {ast.unparse(total(ref.terms))}")
        return True

    # --- expressions ----------------------------------------------------------------------------------

    def ref(self, node):
        """The record, the records or the numbers that an expression stands for; None if it is a value."""
        if isinstance(node, ast.Name):
            return self.records.get(node.id)
        if isinstance(node, ast.Attribute):
            outer = self.ref(node.value)
            if node.attr == "raw" and outer and not outer.terms:
                return outer
            if node.attr == "shape":  # of an array
                return None
            if outer is None:
                self.refuse(node, f"{ast.unparse(node.value)} is no record")
            place = Ref(
                self.field(node, outer.kind),
                outer.array,
                [*outer.terms, self.layout.offset(outer.kind, node.attr)],
            )
            if node.attr in outer.kind.targets and isinstance(node.ctx, ast.Load):
                if is_root(outer.kind.targets[node.attr]):  # the array's own head
                    return Ref(outer.kind.targets[node.attr], outer.array, [])
                return Ref(
                    outer.kind.targets[node.attr],
                    outer.array,
                    [*outer.terms, integer(self.element(place, ast.Load()))],
                )
            return place
        if isinstance(node, ast.Subscript):
            outer = self.ref(node.value)
            if outer is None:
                return None
            many = hasattr(outer.kind, "_length_")
            element, index = outer.kind._type_ if many else float, self.visit(deepcopy(node.slice))
            if not (is_record(element) or is_run(element)):
                middle = getattr(outer.kind, "middle", 0) if many else 0
                return Ref(
                    float, outer.array, [*outer.terms, *([ast.Constant(middle)] if middle else []), index]
                )
            terms = [] if ast.unparse(index) == "0" else [ast.BinOp(numbers(element), ast.Mult(), index)]
            return Ref(element, outer.array, [*outer.terms, *terms])
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "at":
            kind, outer = self.layout.classes.get(ast.unparse(node.func.value)), self.ref(node.args[0])
            array, terms = (outer.array, outer.terms) if outer else (node.args[0].id, [])
            return Ref(kind, array, [*terms, *(self.visit(deepcopy(argument)) for argument in node.args[1:])])
        if isinstance(node, ast.Call):
            kind = self.results.get(self.function_key(ast.unparse(node.func)))
            return (
                Ref(kind, self.array_name(self.layout.home(kind)[0]), [self.visit(deepcopy(node))])
                if kind
                else None
            )
        return None

    def function_key(self, name):
        """(module, function) of a function as this module calls it."""
        return self.origins.get(name, self.name), name

    def field(self, node, kind):
        """The type of a record's field."""
        fields = dict(kind._fields_) if hasattr(kind, "_fields_") else {}
        if node.attr not in fields and "_" + node.attr not in fields:
            self.refuse(node, f"{getattr(kind, '__name__', 'an array')} has no field {node.attr}")
        if node.attr in kind.targets:
            return int
        return kind.scalars.get(node.attr) or fields.get(node.attr) or fields["_" + node.attr]

    def value(self, node):
        """A field or an element as the dialect reads it."""
        ref = self.ref(node)
        if ref is None:
            return self.generic_visit(node)
        if isinstance(node, ast.Attribute) and node.attr == "raw":
            return ast.Name(ref.array, ast.Load())
        if is_record(ref.kind) or is_run(ref.kind):
            self.refuse(node, f"{ast.unparse(node)} is no number")
        place = self.element(ref, node.ctx)
        if isinstance(node.ctx, ast.Load) and ref.kind is int:
            return integer(place)
        if isinstance(node.ctx, ast.Load) and ref.kind is bool:
            return ast.Compare(place, [ast.Eq()], [ast.Constant(1.0)])
        return place

    visit_Attribute = visit_Subscript = value

    @staticmethod
    def element(ref, ctx):
        """The number that stands at a reference."""
        return ast.Subscript(ast.Name(ref.array, ast.Load()), total(ref.terms), ctx)

    def visit_Assign(self, node):
        target, pointed = node.targets[0], self.ref(node.value)
        ref = self.ref(target) if isinstance(target, (ast.Attribute, ast.Subscript)) else None
        if ref and pointed and is_record(pointed.kind):
            outer = self.ref(target.value)
            if outer.kind.targets.get(getattr(target, "attr", None)) is not pointed.kind:
                self.refuse(node, f"{ast.unparse(target)} is not where a {pointed.kind.__name__} begins")
            value = ast.Call(ast.Name("float", ast.Load()), [distance(pointed, outer)], [])
            return ast.Assign([self.visit(target)], value, lineno=node.lineno)
        if ref and ref.kind in (int, bool):
            node.value = ast.Call(ast.Name("float", ast.Load()), [node.value], [])
        return self.generic_visit(node)

    def visit_AugAssign(self, node):
        ref = self.ref(node.target) if isinstance(node.target, (ast.Attribute, ast.Subscript)) else None
        if ref and ref.kind in (int, bool):
            self.refuse(node, "a whole number in a record is written as a whole: x.n = x.n + 1")
        return self.generic_visit(node)

    def visit_Call(self, node):
        name = ast.unparse(node.func)
        if name == "offset":
            return distance(self.ref(node.args[0]), self.ref(node.args[1]))
        parameters = self.signatures.get(self.function_key(name), [])
        if not any(kind for _, kind in parameters):
            return self.generic_visit(node)
        if len(parameters) != len(node.args):
            self.refuse(node, f"{name} has {len(parameters)} parameters")
        arguments = [
            ast.Name(self.array_name(array), ast.Load()) for array in added_arrays(parameters, self.layout)
        ]
        for (parameter, kind), argument in zip(parameters, node.args):
            ref = self.ref(argument) if kind else None
            if kind and (ref is None or ref.kind is not kind):
                self.refuse(argument, f"{name} wants a {kind.__name__} as its {parameter}")
            if kind is None:
                arguments.append(self.visit(argument))
            elif is_root(kind):
                arguments.append(ast.Name(ref.array, ast.Load()))
            elif self.layout.home(kind)[1] is None:
                arguments.append(total(ref.terms))
        return ast.Call(node.func, arguments, [])

    def visit_Name(self, node):
        ref = self.records.get(node.id)
        if ref and is_root(ref.kind) and not ref.terms:
            return ast.Name(ref.array, node.ctx)  # the whole array, to a function that takes arrays
        if ref:
            self.refuse(node, f"the record {node.id} is used as a number")
        return node

    # --- text -----------------------------------------------------------------------------------------

    def replace(self, node):
        """The text of a statement or expression anew, if it changes; comments around it stay."""
        before = ast.unparse(node)
        after = ast.unparse(self.visit(node))
        if after != before:
            self.edit(node, node, after)

    def edit(self, first, last, text):
        self.edits.append(((first.lineno, first.col_offset), (last.end_lineno, last.end_col_offset), text))

    def imports(self):
        """The constants that the lowered text names come from layout, records do not."""
        wanted = self.layout.values.keys() & {
            word for _, _, text in self.edits for word in re.findall(r"\w+", text)
        }
        for node in self.tree.body:
            if isinstance(node, ast.ImportFrom) and node.module == "layout":
                names = wanted.union(alias.name for alias in node.names)
                names -= {*self.layout.classes, *WORDS, *MARKS}
                self.edit(node, node, f"from .layout import {', '.join(sorted(names))}" if names else "")
            elif isinstance(node, ast.ImportFrom) and node.module == "record":
                self.edit(node, node, "")

    def text(self):
        for start, stop, text in sorted(self.edits, reverse=True):
            head, tail = self.lines[start[0] - 1][: start[1]], self.lines[stop[0] - 1][stop[1] :]
            self.lines[start[0] - 1 : stop[0]] = [head + text.encode() + tail]
        return b"\n".join(self.lines)


def numbers(kind):
    """How many numbers a record or a run is, of a record by name."""
    return (
        ast.Name(f"{constant(kind.__name__)}_SIZE", ast.Load())
        if is_record(kind)
        else ast.Constant(sizeof(kind) // 8)
    )


def integer(expression):
    """``int(expression)``."""
    return ast.Call(ast.Name("int", ast.Load()), [expression], [])


def record_parameters(node, layout):
    """(name, record class or None) of a function's parameters."""
    return [(a.arg, layout.classes.get(ast.unparse(a.annotation).strip("'"))) for a in node.args.args]


def added_arrays(parameters, layout):
    """The arrays that a function's records live in and that it is not given anyway."""
    kinds = [kind for _, kind in parameters if kind]
    return [
        array
        for array in ARRAYS
        if array in {layout.home(kind)[0] for kind in kinds if not is_root(kind)}
        and array not in {kind.array for kind in kinds if is_root(kind)}
    ]


def lower(texts, module):
    """Modules without records, {name: text}, from modules with, and the imported layout."""
    layout = Layout(module)
    functions = [
        (name, node)
        for name, text in texts.items()
        for node in ast.parse(text).body
        if isinstance(node, ast.FunctionDef)
    ]
    signatures = {(name, node.name): record_parameters(node, layout) for name, node in functions}
    results = {
        (name, node.name): layout.classes[node.returns.id]
        for name, node in functions
        if node.returns and node.returns.id not in NUMBERS
    }
    lowered, refusals, around = {}, [], repr((layout.values, signatures, results))
    for name in texts.keys() - {"layout"}:
        try:
            if (name, texts[name], around) not in KNOWN:
                one = Lowered(name, texts[name], layout, signatures, results)
                KNOWN[name, texts[name], around] = one.text()
            lowered[name] = KNOWN[name, texts[name], around]
        except Refused as refusal:
            refusals.append(str(refusal))
    if refusals:
        raise Refused("\n".join(sorted(refusals)))
    finals = {
        name: value
        for name, value in vars(module).items()
        if name.isupper() and isinstance(value, (int, float))
    }
    lines = [
        f"{name}: Final[{type(value).__name__}] = {value!r}"
        for name, value in (finals | layout.values).items()
    ]
    docstring = ast.get_docstring(ast.parse(texts["layout"]))
    lowered["layout"] = "\n".join(
        [f'"""{docstring}"""', "", "from typing import Final", "", *lines, ""]
    ).encode()
    return lowered
