"""Differentiate the kernel's Python: from its modules to modules that carry a rate beside every value (forward mode).

The dialect is small: functions of floats, ints and arrays of floats.  For every function on the way of a step that returns or
writes something that follows the inputs there is one with ``_t`` at its name's end: behind each float and each array
that follows the inputs stands another of the same name with ``_t``, its rate along the seed.  Values are computed as they
were, operation by operation, so that they have the kernel's own bits and every branch is the one that a step takes.

Tables are constant, and so is ``state``, which never changes an answer.  Searches and iterations are not differentiated; what
they find is, by the rules of implicit.py: RULES tells which function stands in for which, and there

    held(x)             x as a constant
    moving(x, other)    x, with the rate of ``other``
    seeded(x, rate)     x, with this rate
    rate_of(x)          the rate of x as a value
    differentiated(f(...))  the call of a function for which there is a rule, differentiated as it is written

and a plain call of a function that has a rule is the kernel's own: whatever it writes has no rate until the rule gives it one.
"""

import ast
from collections import namedtuple

#: What stands in for an iteration when the kernel is differentiated: a function of implicit.py.
RULES = {
    "open_region": "minimum_rule", "zone_width": "width_rule", "find_hump": "hump_rule", "solve_levels": "levels_rule",
    "touching_pair": "pair_rule",
    "upright_coefficients": "upright_rule", "move_arc": "arc_rule", "move_chord": "chord_rule", "move_across": "across_rule",
    "normal_line": "line_rule", "find_overlaps": "overlaps_rule",
}
#: Called as they are: they look for places from which an iteration starts.
SEARCHES = {"scan_side"}
#: A part of a rule, and the function whose rule it is a part of.
PARTS = {"turning_rule": "find_overlaps", "width_jet": "zone_width"}
#: Called by the rules as it is: it solves for rates.
RATE_SOLVER = "eliminate"
RULE_MODULE = "implicit"
ROOT = "differentiate"
ACTIVE_ARRAYS = {"work", "place"}
INTRINSICS = {"held", "moving", "seeded", "rate_of", "differentiated"}
#: Rates of functions of one argument, where {v} is the argument, {f} the value and {d} the argument's rate.
RATES = {"sqrt": "root_rate({f}, {d})", "fabs": "size_rate({v}, {d})", "log": "{d} / {v}", "sin": "cos({v}) * {d}",
         "cos": "-sin({v}) * {d}", "atan": "{d} / (1.0 + {v} * {v})"}
HELPERS = '''"""How roots and sizes change: helpers of the differentiated kernel."""


def root_rate(root: float, rate: float):
    """Rate of a square root whose argument changes by ``rate``; 0 where the root is 0."""
    result = 0.0
    if root != 0.0:
        result = 0.5 * rate / root
    return result


def size_rate(value: float, rate: float):
    """Rate of abs(value)."""
    result = rate
    if value < 0.0:
        result = -rate
    return result


def power_rate(power: float, base: float, exponent: float, rate: float):
    """Rate of base ** exponent; 0 where the base is 0."""
    result = 0.0
    if base != 0.0:
        result = exponent * power / base * rate
    return result
'''

Pair = namedtuple("Pair", "value rate")         # texts; the rate is None for what is constant


def tangent_modules(modules):
    """Text of every differentiated module by name, from the kernel's parsed modules."""
    kernel = Kernel(modules)
    kernel.reach(RULE_MODULE, ROOT)
    texts = {"tangent_rates": HELPERS}
    for place in kernel.modules:
        functions = [(module.name, name) for module in modules for name in module.functions
                     if (module.name, name) in kernel.wanted and kernel.place(module.name, name) == place]
        if functions:
            texts[f"tangent_{place}"] = kernel.module_text(place, functions)
    return texts


class Kernel:
    """All modules, and what is known of their functions."""

    def __init__(self, modules):
        self.modules = {module.name: module for module in modules}
        self.homes = {}
        for module in modules:
            for name in module.functions:
                self.homes.setdefault(name, []).append(module.name)
        self.known_returns, self.wanted, self.known_writes = {}, set(), {}

    def home(self, module, name):
        """The module that defines the function ``name`` as ``module`` sees it; None if it is not the kernel's."""
        if name in self.modules[module].functions:
            return module
        return next((home for home, names in self.modules[module].imports.items()
                     if name in names and name in self.modules[home].functions), None)

    def node(self, module, name):
        return self.modules[module].functions[name]

    def returns(self, module, name):
        """Kinds, 'float', 'int' or 'bool', of what a function returns."""
        key = module, name
        if key not in self.known_returns:
            self.known_returns[key] = ()
            scope = Scope(self, module, self.node(*key))
            found = [node.value for node in ast.walk(scope.node) if isinstance(node, ast.Return)]
            values = found[0].elts if isinstance(found[0], ast.Tuple) else [found[0]]
            self.known_returns[key] = tuple(scope.kind(value) for value in values)
            if self.known_returns[key] == ("call",):
                call = found[0]
                self.known_returns[key] = self.returns(self.home(module, call.func.id), call.func.id)
        return self.known_returns[key]

    def writes(self, module, name):
        """Whether a function, or one that it calls, writes to an array."""
        key = module, name
        if key not in self.known_writes:
            self.known_writes[key] = False
            nodes = list(ast.walk(self.node(*key)))
            found = any(isinstance(node, ast.Subscript) and isinstance(node.ctx, ast.Store) for node in nodes)
            for node in nodes:
                if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                    home = self.home(module, node.func.id)
                    found = found or home is not None and self.writes(home, node.func.id)
            self.known_writes[key] = found
        return self.known_writes[key]

    def is_active(self, module, name):
        """Whether a function has rates to hand on."""
        kinds = [kind for _, kind in parameters(self.node(module, name))]
        arrays = [parameter for parameter, kind in parameters(self.node(module, name)) if kind == "array"]
        follows = "float" in kinds or bool(ACTIVE_ARRAYS & set(arrays))
        returns = "float" in self.returns(module, name)
        return follows and (returns or self.writes(module, name) and bool(ACTIVE_ARRAYS & set(arrays)))

    def differentiated(self, module, name):
        """(module, function) whose tangent a call of ``name`` in ``module`` stands for; None where the call stays as it is."""
        home = self.home(module, name)
        if home is None or name in INTRINSICS or name in SEARCHES or module == RULE_MODULE and name in {*RULES, RATE_SOLVER}:
            return None
        if name in RULES:
            return RULE_MODULE, RULES[name]
        return (home, name) if self.is_active(home, name) else None

    def reach(self, module, name):
        """Note a function as wanted, with all whose tangents it calls."""
        if (module, name) in self.wanted:
            return
        self.wanted.add((module, name))
        for node in ast.walk(self.node(module, name)):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                called = self.called(module, node)
                if called:
                    self.reach(*called)

    def called(self, module, call):
        """``differentiated`` of a call, also of ``differentiated(f(...))``."""
        if call.func.id == "differentiated":
            return self.home(module, call.args[0].func.id), call.args[0].func.id
        return self.differentiated(module, call.func.id)

    def place(self, module, name):
        """The module beside whose tangents that of a function stands: a rule beside what it is the rule of."""
        replaced = {**{rule: function for function, rule in RULES.items()}, **PARTS}
        return self.home(RULE_MODULE, replaced[name]) if module == RULE_MODULE and name in replaced else module

    def module_text(self, place, functions):
        """The text of one differentiated module, of functions each of which is (module, name)."""
        bodies = [Differentiated(self, module, self.node(module, name)) for module, name in functions]
        texts = [body.text() for body in bodies]
        used, imported = set(), {}
        for body, text in zip(bodies, texts):
            names = {node.id for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Name)}
            used |= names
            module = self.modules[body.module]
            for home, offered in [*module.imports.items(), (module.name, {*module.constants, *module.functions})]:
                imported.setdefault(home, set()).update(names & set(offered))
        lines = [f'"""Tangents of {place}.py."""', ""]
        mathematics = sorted(used & {"acos", "asin", "atan", "atan2", "cos", "fabs", "isfinite", "log", "pi", "sin", "sqrt"})
        if mathematics:
            lines.append(f"from math import {', '.join(mathematics)}")
        lines += [f"from .{home} import {', '.join(sorted(names))}" for home, names in sorted(imported.items()) if names]
        rates = sorted(used & {"root_rate", "size_rate", "power_rate"})
        if rates:
            lines.append(f"from .tangent_rates import {', '.join(rates)}")
        calls = {}
        for body in bodies:
            for home, name in body.tangents:
                if self.place(home, name) != place:
                    calls.setdefault(self.place(home, name), set()).add(name + "_t")
        lines += [f"from .tangent_{home} import {', '.join(sorted(names))}" for home, names in sorted(calls.items())]
        return "\n".join(lines) + "\n\n\n" + "\n\n\n".join(texts) + "\n"


def parameters(node):
    """(name, kind) of the parameters of a function, as annotated."""
    kinds = {"float": "float", "int": "int", "'float[:]'": "array"}
    return [(argument.arg, kinds[ast.unparse(argument.annotation)]) for argument in node.args.args]


class Scope:
    """One function: the kinds of its names, and which of them follow the inputs."""

    def __init__(self, kernel, module, node):
        self.kernel, self.module, self.node = kernel, module, node
        self.kinds = dict(parameters(node))
        for statement in sorted((n for n in ast.walk(node) if isinstance(n, (ast.Assign, ast.For))), key=lambda n: n.lineno):
            if isinstance(statement, ast.For):
                self.kinds.setdefault(statement.target.id, "int")
                continue
            target, value = statement.targets[0], statement.value
            if isinstance(target, ast.Name):
                self.kinds.setdefault(target.id, self.kind(value))
            elif isinstance(target, ast.Tuple):
                kinds = [self.kind(element) for element in value.elts] if isinstance(value, ast.Tuple) else self.call_kinds(value)
                for element, kind in zip(target.elts, kinds):
                    if isinstance(element, ast.Name):
                        self.kinds.setdefault(element.id, kind)

    def call_kinds(self, call):
        """Kinds of what a call returns."""
        if call.func.id == "differentiated":
            call = call.args[0]
        return self.kernel.returns(self.kernel.home(self.module, call.func.id), call.func.id)

    def kind(self, node):
        """Kind of an expression."""
        if isinstance(node, ast.Constant):
            return type(node.value).__name__
        if isinstance(node, ast.Name):
            return self.kinds.get(node.id) or self.constant_kind(node.id)
        if isinstance(node, ast.Subscript):
            return "float"
        if isinstance(node, (ast.Compare, ast.BoolOp)):
            return "bool"
        if isinstance(node, ast.UnaryOp):
            return self.kind(node.operand)
        if isinstance(node, ast.BinOp):
            floats = isinstance(node.op, ast.Div) or "float" in (self.kind(node.left), self.kind(node.right))
            return "float" if floats else "int"
        if node.func.id in ("int", "isfinite"):
            return "int" if node.func.id == "int" else "bool"
        if node.func.id in ("held", "moving", "seeded", "rate_of") or self.kernel.home(self.module, node.func.id) is None:
            return "float"
        kinds = self.call_kinds(node)
        return kinds[0] if len(kinds) == 1 else "call"

    def constant_kind(self, name):
        """Kind of a module's constant."""
        if name == "pi":
            return "float"
        homes = [self.module, *(home for home, names in self.kernel.modules[self.module].imports.items() if name in names)]
        for home in homes:
            for node in self.kernel.modules[home].tree.body:
                if isinstance(node, ast.AnnAssign) and node.target.id == name:
                    return ast.unparse(node.annotation)[len("Final["):-1]
        raise KeyError(f"{self.module}.py: {name} has no kind")


class Differentiated(Scope):
    """Writes the tangent of one function."""

    def __init__(self, kernel, module, node):
        super().__init__(kernel, module, node)
        self.tangents, self.lines, self.depth, self.count = set(), [], 1, 0
        self.active = {name for name, kind in self.kinds.items() if kind == "float" and name in dict(parameters(node))}
        self.names = {n.id for n in ast.walk(node) if isinstance(n, ast.Name)} | set(self.kinds)
        before = -1
        while len(self.active) != before:
            before = len(self.active)
            for statement in ast.walk(node):
                if isinstance(statement, ast.Assign):
                    self.note_active(statement.targets[0], statement.value)
                elif isinstance(statement, ast.AugAssign):
                    self.note_active(statement.target, statement.value)

    def note_active(self, target, value):
        targets = target.elts if isinstance(target, ast.Tuple) else [target]
        values = value.elts if isinstance(value, ast.Tuple) else [value] * len(targets)
        for one, its in zip(targets, values):
            if isinstance(one, ast.Name) and self.kinds[one.id] == "float" and self.follows(its):
                self.active.add(one.id)

    def follows(self, node):
        """Whether an expression has a rate."""
        if isinstance(node, ast.Name):
            return node.id in self.active
        if isinstance(node, ast.Subscript):
            return node.value.id in ACTIVE_ARRAYS
        if isinstance(node, ast.Call):
            name = node.func.id
            if name in ("int", "isfinite", "held", "rate_of"):
                return False
            if name in ("moving", "seeded", "differentiated"):
                return True
            if self.kernel.home(self.module, name) is not None:
                return self.kernel.differentiated(self.module, name) is not None
            return any(self.follows(argument) for argument in node.args)
        if isinstance(node, (ast.Compare, ast.BoolOp)):
            return False
        return any(self.follows(child) for child in ast.iter_child_nodes(node))

    def text(self):
        """The function's text."""
        names = []
        for name, kind in parameters(self.node):
            annotation = "'float[:]'" if kind == "array" else kind
            names.append(f"{name}: {annotation}")
            if kind == "float" or kind == "array" and name in ACTIVE_ARRAYS:
                names.append(f"{name}_t: {annotation}")
        self.block([n for n in self.node.body if not (isinstance(n, ast.Expr) and isinstance(n.value, ast.Constant))])
        head = f"def {self.node.name}_t({', '.join(names)}):"
        text = "\n".join([head, f'    """Tangent of ``{self.node.name}``."""', *self.lines])
        return ast.unparse(ast.parse(text))         # in as few parentheses as the meaning needs

    def write(self, line):
        self.lines.append("    " * self.depth + line)

    def fresh(self, letter):
        """A name that the function does not have."""
        self.count += 1
        name = f"{letter}{self.count}"
        return name if name not in self.names else self.fresh(letter)

    def block(self, statements, deeper=0):
        self.depth += deeper
        for statement in statements:
            getattr(self, "write_" + type(statement).__name__.lower())(statement)
        self.depth -= deeper

    # --- statements -----------------------------------------------------------------------------------

    def write_if(self, node):
        self.write(f"if {self.value(node.test)}:")
        self.block(node.body, 1)
        if node.orelse:
            self.write("else:")
            self.block(node.orelse, 1)

    def write_for(self, node):
        self.write(f"for {node.target.id} in {self.value(node.iter)}:")
        self.block(node.body, 1)

    def write_while(self, node):
        before = len(self.lines)
        test = self.value(node.test)
        if len(self.lines) > before:
            raise ValueError(f"{self.module}.py, line {node.lineno}: a while loop's condition calls what changes something")
        self.write(f"while {test}:")
        self.block(node.body, 1)

    def write_break(self, node):
        self.write("break")

    def write_pass(self, node):
        self.write("pass")

    def write_expr(self, node):
        self.call_statement(node.value, [])

    def write_return(self, node):
        values = node.value.elts if isinstance(node.value, ast.Tuple) else [node.value]
        kinds = self.kernel.returns(self.module, self.node.name)
        if len(values) == 1 and isinstance(values[0], ast.Call) and len(kinds) > 1:
            names = [self.fresh("r") for _ in kinds]
            self.results(values[0], [ast.Name(name, ast.Store()) for name in names])
            results = [text for name, kind in zip(names, kinds)
                       for text in ([name, name + "_t"] if kind == "float" else [name])]
        else:
            results = []
            for value in values:
                if self.kind(value) == "float":
                    pair = self.pair(value)
                    results += [pair.value, pair.rate or "0.0"]
                else:
                    results.append(self.value(value))
        self.write(f"return {', '.join(results)}")

    def results(self, call, targets):
        """A call of several results into targets of which all floats have rates."""
        self.active |= {target.id for target in targets if isinstance(target, ast.Name)}
        self.call_statement(call, targets)

    def write_assign(self, node):
        target, value = node.targets[0], node.value
        if isinstance(target, ast.Tuple) and isinstance(value, ast.Call):
            self.call_statement(value, target.elts)
        elif isinstance(target, ast.Tuple):
            raise ValueError(f"{self.module}.py, line {node.lineno}: one assignment for each value")
        else:
            self.assign(target, value)

    def write_augassign(self, node):
        load = ast.parse(ast.unparse(node.target), mode="eval").body
        if isinstance(node.target, ast.Subscript) and has_call(node.target.slice):
            at = self.fresh("k")
            self.write(f"{at} = {self.value(node.target.slice)}")
            load = ast.parse(f"{node.target.value.id}[{at}]", mode="eval").body
        self.assign(load, ast.BinOp(load, node.op, node.value))

    def assign(self, target, value):
        """One value with its rate, where there is one, into a name or an array's place."""
        if isinstance(target, ast.Name):
            if self.kinds[target.id] != "float" or target.id not in self.active:
                self.write(f"{target.id} = {self.value(value)}")
                return
            place, rate_place = target.id, target.id + "_t"
        else:
            index = self.value(target.slice)
            if has_call(target.slice):
                at = self.fresh("k")
                self.write(f"{at} = {index}")
                index = at
            array = target.value.id
            place, rate_place = f"{array}[{index}]", f"{array}_t[{index}]"
            if array not in ACTIVE_ARRAYS:
                self.write(f"{place} = {self.value(value)}")
                return
        pair = self.pair(value)
        self.write(f"{rate_place} = {pair.rate or '0.0'}")
        if pair.value != place:
            self.write(f"{place} = {pair.value}")

    def call_statement(self, call, targets):
        """A call as a statement of its own, its results into ``targets``."""
        tangent = self.kernel.called(self.module, call)
        if call.func.id == "differentiated":
            call = call.args[0]
        home = self.kernel.home(self.module, call.func.id)
        kinds = self.kernel.returns(home, call.func.id)
        if len(kinds) > 1 and not targets:
            targets = [ast.Name(self.fresh("n"), ast.Store()) for _ in kinds]
            self.active |= {target.id for target in targets}
        names = [ast.unparse(target) for target in targets]
        if tangent is None:
            text = self.value(call, own=True)
            self.write(f"{', '.join(names)} = {text}" if names else text)
            for target, name, kind in zip(targets, names, kinds):
                if kind == "float" and name in self.active:
                    self.write(f"{name}_t = 0.0")
            return
        results = [text for name, kind in zip(names, kinds) for text in ([name, name + "_t"] if kind == "float" else [name])]
        if not names and "float" in kinds:
            results = [self.fresh("n"), self.fresh("n")]
        text = self.tangent_call(call, tangent)
        self.write(f"{', '.join(results)} = {text}" if results else text)

    def tangent_call(self, call, tangent):
        """The text of a tangent's call."""
        self.tangents.add(tangent)
        arguments = []
        for (name, kind), argument in zip(parameters(self.kernel.node(*tangent)), call.args):
            if kind == "array":
                arguments += [argument.id, argument.id + "_t"] if name in ACTIVE_ARRAYS else [argument.id]
            elif kind == "float":
                pair = self.pair(argument)
                arguments += [pair.value, pair.rate or "0.0"]
            else:
                arguments.append(self.value(argument))
        return f"{tangent[1]}_t({', '.join(arguments)})"

    # --- expressions ----------------------------------------------------------------------------------

    def value(self, node, own=False):
        """Text of an expression's value; calls that change something stand before it.  ``own``: a call that stays one."""
        if isinstance(node, ast.Call) and node.func.id in ("held", "moving", "seeded"):
            return self.value(node.args[0])
        if isinstance(node, ast.Call) and node.func.id == "rate_of":
            return self.pair(node.args[0]).rate or "0.0"
        if isinstance(node, ast.Call) and not own:
            home = self.kernel.home(self.module, node.func.id)
            if home is not None and self.kernel.writes(home, node.func.id):
                name = self.fresh("n")
                kinds = self.kernel.returns(home, node.func.id)
                tangent = self.kernel.differentiated(self.module, node.func.id)
                if tangent is None:
                    self.write(f"{name} = {self.value(node, own=True)}")
                else:
                    results = f"{name}, {name}_t" if kinds == ("float",) else name
                    self.write(f"{results} = {self.tangent_call(node, tangent)}")
                return name
        if isinstance(node, ast.BoolOp):
            before = len(self.lines)
            parts = [self.operand(part) for part in node.values]
            if len(self.lines) > before:
                raise ValueError(f"{self.module}.py, line {node.lineno}: one of several conditions calls what changes something")
            return (" and " if isinstance(node.op, ast.And) else " or ").join(parts)
        if isinstance(node, ast.Call):
            return f"{node.func.id}({', '.join(self.value(argument) for argument in node.args)})"
        if isinstance(node, ast.Compare):
            return f"{self.value(node.left)} {OPERATORS[type(node.ops[0])]} {self.value(node.comparators[0])}"
        if isinstance(node, ast.Subscript):
            return f"{node.value.id}[{self.value(node.slice)}]"
        if isinstance(node, ast.BinOp):
            return f"{self.operand(node.left)} {OPERATORS[type(node.op)]} {self.operand(node.right)}"
        if isinstance(node, ast.UnaryOp):
            sign = "not " if isinstance(node.op, ast.Not) else "-"
            return f"{sign}{self.operand(node.operand)}"
        return ast.unparse(node)

    def operand(self, node):
        """Text of a value as part of a larger expression."""
        text = self.value(node)
        return text if is_atom(text) else f"({text})"

    def atom(self, node):
        """A pair whose value is a name, a number or an array's element."""
        pair = self.pair(node)
        return Pair(self.named(pair.value), pair.rate)

    def named(self, text):
        """A name for the value ``text``, or itself if it is one already."""
        if is_atom(text):
            return text
        name = self.fresh("v")
        self.write(f"{name} = {text}")
        return name

    def pair(self, node):
        """Value and rate of an expression of floats."""
        if not self.follows(node) and not (isinstance(node, ast.Call) and node.func.id == "rate_of"):
            text = self.value(node)
            return Pair(text, None)
        if isinstance(node, ast.Name):
            return Pair(node.id, node.id + "_t")
        if isinstance(node, ast.Subscript):
            index = self.value(node.slice)
            if has_call(node.slice):
                at = self.fresh("k")
                self.write(f"{at} = {index}")
                index = at
            return Pair(f"{node.value.id}[{index}]", f"{node.value.id}_t[{index}]")
        if isinstance(node, ast.UnaryOp):
            pair = self.pair(node.operand)
            return Pair(f"-{closed(pair.value)}", f"-{closed(pair.rate)}")
        if isinstance(node, ast.BinOp):
            return self.binary(node)
        return self.call(node)

    def binary(self, node):
        """Value and rate of a sum, product, quotient or power."""
        if isinstance(node.op, (ast.Add, ast.Sub)):
            left, right = self.pair(node.left), self.pair(node.right)
            sign = OPERATORS[type(node.op)]
            rate = " ".join(filter(None, (left.rate, right.rate and f"{sign} {closed(right.rate)}")))
            return Pair(f"{closed(left.value)} {sign} {closed(right.value)}",
                        rate if left.rate else rate.removeprefix("+ ").replace("- ", "-", 1))
        left, right = self.atom(node.left), self.atom(node.right)
        if isinstance(node.op, ast.Mult):
            parts = [f"{closed(left.rate)} * {right.value}" if left.rate else "",
                     f"{left.value} * {closed(right.rate)}" if right.rate else ""]
            return Pair(f"{left.value} * {right.value}", " + ".join(filter(None, parts)))
        if isinstance(node.op, ast.Div):
            if not right.rate:
                return Pair(f"{left.value} / {right.value}", f"{closed(left.rate)} / {right.value}")
            quotient = self.named(f"{left.value} / {right.value}")
            rate = f"{closed(left.rate)} - {quotient} * {closed(right.rate)}" if left.rate else f"-{quotient} * {closed(right.rate)}"
            return Pair(quotient, f"({rate}) / {right.value}")
        if isinstance(node.op, ast.Pow) and not right.rate:
            power = self.named(f"{left.value} ** {right.value}")
            return Pair(power, f"power_rate({power}, {left.value}, {right.value}, {left.rate})")
        raise ValueError(f"{self.module}.py, line {node.lineno}: this operation has no rate")

    def call(self, node):
        """Value and rate of a call."""
        name = node.func.id
        if name == "moving":
            other = self.pair(node.args[1])
            return Pair(self.value(node.args[0]), other.rate)
        if name == "seeded":
            return Pair(self.value(node.args[0]), self.value(node.args[1]))
        if name == "rate_of":
            return Pair(self.pair(node.args[0]).rate or "0.0", None)
        tangent = self.kernel.called(self.module, node)
        if tangent:
            result = self.fresh("v")
            call = node.args[0] if name == "differentiated" else node
            self.write(f"{result}, {result}_t = {self.tangent_call(call, tangent)}")
            return Pair(result, result + "_t")
        if name == "atan2":
            up, along = self.atom(node.args[0]), self.atom(node.args[1])
            square = f"({along.value} * {along.value} + {up.value} * {up.value})"
            return Pair(f"atan2({up.value}, {along.value})",
                        f"({along.value} * {closed(up.rate or '0.0')} - {up.value} * {closed(along.rate or '0.0')}) / {square}")
        argument = self.atom(node.args[0])
        value = f"{name}({argument.value})"
        if "{f}" in RATES[name]:
            value = self.named(value)
        return Pair(value, RATES[name].format(v=argument.value, f=value, d=closed(argument.rate)))


OPERATORS = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.FloorDiv: "//", ast.Mod: "%", ast.Pow: "**",
             ast.LShift: "<<", ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!="}


def has_call(node):
    """Whether an expression calls something."""
    return any(isinstance(part, ast.Call) for part in ast.walk(node))


def is_atom(text):
    """Whether a text is a name, a number, an array's element or a call."""
    node = ast.parse(text, mode="eval").body
    return isinstance(node, (ast.Name, ast.Constant, ast.Subscript))


def closed(text):
    """A text as part of a larger expression."""
    node = ast.parse(text, mode="eval").body
    return text if isinstance(node, (ast.Name, ast.Constant, ast.Subscript, ast.Call)) else f"({text})"
