"""The kernel's modules, which of their functions are differentiated, and the text of
the modules that result."""

import ast

from .rules import ACTIVE_ARRAYS, HELPERS, INTRINSICS, PARTS, RATE_FUNCTIONS, ROOT, RULE_MODULES, RULES
from .scope import Scope, parameters
from .statements import Differentiated


def derivative_modules(modules):
    """Text of every differentiated module by name, from the kernel's parsed modules."""
    kernel = Kernel(modules)
    kernel.reach(kernel.rule_homes[ROOT], ROOT)
    texts = {"derivative_rates": HELPERS}
    for place in kernel.modules:
        functions = [
            (module.name, name)
            for module in modules
            for name in module.functions
            if (module.name, name) in kernel.wanted and kernel.place(module.name, name) == place
        ]
        if functions:
            texts[f"derivative_{place}"] = kernel.module_text(place, functions)
    return texts


class Kernel:
    """All modules, and what is known of their functions."""

    def __init__(self, modules):
        self.modules = {module.name: module for module in modules}
        self.homes = {}
        for module in modules:
            for name in module.functions:
                self.homes.setdefault(name, []).append(module.name)
        #: The module of each rule.
        self.rule_homes = {
            name: home
            for home in RULE_MODULES
            if home in self.modules
            for name in self.modules[home].functions
        }
        self.known_returns, self.wanted, self.known_writes, self.known_active = {}, set(), {}, {}
        self.known_kinds = {}

    def home(self, module, name):
        """The module that defines the function ``name`` as ``module`` sees it; None
        if it is not the kernel's."""
        if name in self.modules[module].functions:
            return module
        return next(
            (
                home
                for home, names in self.modules[module].imports.items()
                if name in names and name in self.modules[home].functions
            ),
            None,
        )

    def node(self, module, name):
        return self.modules[module].functions[name]

    def returns(self, module, name):
        """Kinds, 'float', 'int' or 'bool', of what a function returns; also 'rate', of a derivative."""
        key = module, name
        written = self.node(*key).returns
        if isinstance(written, ast.Constant):  # of a derivative
            return tuple(written.value.split(", "))
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
        if (module, name) not in self.known_active:
            self.known_active[module, name] = self.hands_on_rates(module, name)
        return self.known_active[module, name]

    def hands_on_rates(self, module, name):
        """``is_active``, found from the function's parameters, results and statements."""
        kinds = [kind for _, kind in parameters(self.node(module, name))]
        arrays = [parameter for parameter, kind in parameters(self.node(module, name)) if kind == "array"]
        follows = "float" in kinds or bool(ACTIVE_ARRAYS & set(arrays))
        returns = "float" in self.returns(module, name)
        return follows and (returns or self.writes(module, name) and bool(ACTIVE_ARRAYS & set(arrays)))

    def differentiated(self, module, name):
        """(module, function) whose derivative a call of ``name`` in ``module`` stands for; None where
        the call stays as it is."""
        home = self.home(module, name)
        if home is None or name in INTRINSICS or module in RULE_MODULES and name in RULES:
            return None
        if name in RULES:
            return self.rule_homes[RULES[name]], RULES[name]
        return (home, name) if self.is_active(home, name) else None

    def reach(self, module, name):
        """Note a function as wanted, with all whose derivatives it calls."""
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
        """The module beside whose derivatives that of a function stands: a rule beside
        what it is the rule of."""
        replaced = {**{rule: function for function, rule in RULES.items()}, **PARTS}
        if module in RULE_MODULES and name in replaced:
            return self.home(module, replaced[name])
        return module

    def module_text(self, place, functions):
        """The text of one differentiated module, of functions each of which is (module, name)."""
        bodies = [Differentiated(self, module, self.node(module, name)) for module, name in functions]
        texts = [body.text() for body in bodies]
        used, imported = set(), {}
        for body, text in zip(bodies, texts):
            names = {node.id for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Name)}
            used |= names
            module = self.modules[body.module]
            for home, offered in [
                *module.imports.items(),
                (module.name, {*module.constants, *module.functions}),
            ]:
                imported.setdefault(home, set()).update((names & set(offered)) - RATE_FUNCTIONS)
        lines = [f'"""Derivatives of {place}.py."""', ""]
        mathematics = sorted(used & {"copysign", "fabs", "inf", "isfinite", "nan", "pi", "sqrt"})
        if mathematics:
            lines.append(f"from math import {', '.join(mathematics)}")
        lines += [
            f"from .{home} import {', '.join(sorted(names))}"
            for home, names in sorted(imported.items())
            if names
        ]
        rates = sorted(used & RATE_FUNCTIONS)
        if rates:
            lines.append(f"from .derivative_rates import {', '.join(rates)}")
        calls = {}
        for body in bodies:
            for home, name in body.derivatives:
                if self.place(home, name) != place:
                    calls.setdefault(self.place(home, name), set()).add(name + "_t")
        lines += [
            f"from .derivative_{home} import {', '.join(sorted(names))}"
            for home, names in sorted(calls.items())
        ]
        return "\n".join(lines) + "\n\n\n" + "\n\n\n".join(texts) + "\n"
