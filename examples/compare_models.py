"""Four normal models at one pose with two patches: pressure across the right contact.  Draws
compare_models.png."""

import matplotlib.pyplot as plt

import wrcontact

MODELS = {
    "hertz": ("Hertz", "0.6", "--"),
    "analyn": ("ANALYN", "tab:blue", "-"),
    "analyn_strip": ("strips", "tab:red", "-"),
    "halfspace": ("half-space (complete theory)", "black", ":"),
}
figure, axes = plt.subplots(figsize=(8, 4), layout="constrained")
right = {}
for model, (label, colour, line) in MODELS.items():
    system = wrcontact.ContactSystem(normal_model=model)
    right[model] = system.evaluate(lateral_shift=5e-3, normal_force=78.5e3).right  # [m], [N]
    outline = right[model].outline
    axes.plot(outline.station * 1e3, outline.pressure / 1e6, line, color=colour, label=label, linewidth=2)
    print(
        f"{label:30} penetration {right[model].penetration * 1e6:6.1f} um   area "
        f"{right[model].area * 1e6:6.1f} mm2   "
        f"largest pressure {right[model].max_pressure / 1e6:5.0f} MPa   patches {right[model].patch_count}"
    )
axes.set(
    xlabel="across the rail, over its arc [mm]",
    ylabel="pressure [MPa]",
    title="S1002 on UIC60 1:40, lateral shift 5 mm, 78.5 kN",
)
axes.legend()
figure.savefig("compare_models.png", dpi=150)

# the strip model agrees with the complete theory within 1 %, at about a thousandth of its cost
assert abs(right["analyn_strip"].penetration / right["halfspace"].penetration - 1) < 0.01
