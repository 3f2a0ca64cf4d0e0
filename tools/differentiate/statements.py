"""The derivative of one function, statement by statement."""

import ast

from .expressions import Expressions, has_call
from .rules import ACTIVE_ARRAYS
from .scope import parameters


class Differentiated(Expressions):
    """Writes the derivative of one function."""

    def text(self):
        """The function's text."""
        names = []
        for name, kind in parameters(self.node):
            annotation = "'float[:]'" if kind == "array" else kind
            names.append(f"{name}: {annotation}")
            if kind == "float":
                names.append(f"{name}_t: 'rate'")
            elif kind == "array" and name in ACTIVE_ARRAYS:
                names.append(f"{name}_t: 'rate[:]'")
        self.block(
            [n for n in self.node.body if not (isinstance(n, ast.Expr) and isinstance(n.value, ast.Constant))]
        )
        kinds = self.kernel.returns(self.module, self.node.name)
        results = ", ".join("float, rate" if kind == "float" else kind for kind in kinds)
        head = f"def {self.node.name}_t({', '.join(names)}) -> '{results}':"
        text = "\n".join([head, f'    """Derivative of ``{self.node.name}``."""', *self.lines])
        return ast.unparse(ast.parse(text))  # in as few parentheses as the meaning needs

    def block(self, statements, deeper=0):
        self.depth += deeper
        for statement in statements:
            getattr(self, "write_" + type(statement).__name__.lower())(statement)
        self.depth -= deeper

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
            raise ValueError(
                f"{self.module}.py, line {node.lineno}: a while loop's condition calls what changes something"
            )
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
            results = [
                text
                for name, kind in zip(names, kinds)
                for text in ([name, name + "_t"] if kind == "float" else [name])
            ]
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
        if pair.rate != rate_place:
            self.write(f"{rate_place} = {pair.rate or '0.0'}")
        if pair.value != place:
            self.write(f"{place} = {pair.value}")

    def call_statement(self, call, targets):
        """A call as a statement of its own, its results into ``targets``."""
        derivative = self.kernel.called(self.module, call)
        if call.func.id == "differentiated":
            call = call.args[0]
        home = self.kernel.home(self.module, call.func.id)
        kinds = self.kernel.returns(home, call.func.id)
        if len(kinds) > 1 and not targets:
            targets = [ast.Name(self.fresh("n"), ast.Store()) for _ in kinds]
            self.active |= {target.id for target in targets}
        names = [ast.unparse(target) for target in targets]
        if call.func.id == "copy_run":
            raise ValueError(f"{self.module}.py, line {call.lineno}: copy_run copies no rates")
        if derivative is None:
            text = self.value(call, own=True)
            self.write(f"{', '.join(names)} = {text}" if names else text)
            for target, name, kind in zip(targets, names, kinds):
                if kind == "float" and name in self.active:
                    self.write(f"{name}_t = 0.0")
            return
        results = [
            text
            for name, kind in zip(names, kinds)
            for text in ([name, name + "_t"] if kind == "float" else [name])
        ]
        if not names and "float" in kinds:
            results = [self.fresh("n"), self.fresh("n")]
        text = self.derivative_call(call, derivative)
        self.write(f"{', '.join(results)} = {text}" if results else text)
