"""Build the FMU and step it with fmpy, as a vehicle simulation would.  Draws step_the_fmu.png."""

import fmpy
import matplotlib.pyplot as plt
import numpy as np
from fmpy.simulation import instantiate_fmu

from wrcontact.fmu import build_fmu

folder = fmpy.extract(str(build_fmu("out")))
description = fmpy.read_model_description(folder)
reference = {variable.name: variable.valueReference for variable in description.modelVariables}
slave = instantiate_fmu(folder, description, "CoSimulation")
slave.setupExperiment(startTime=0.0)
slave.enterInitializationMode()
slave.exitInitializationMode()

time, step = np.linspace(0.0, 1.0, 201, retstep=True)
shift = 5e-3 * np.sin(2 * np.pi * 2 * time)  # [m] hunting at 2 Hz
roll = []
for now, place in zip(time, shift):
    slave.setReal([reference["lateral_shift"], reference["normal_force"]], [place, 78.5e3])
    slave.doStep(now, step)
    roll += slave.getReal([reference["roll"]])
slave.terminate()
slave.freeInstance()

plt.plot(time, np.degrees(roll))
plt.gca().set(
    xlabel="time [s]", ylabel="roll of the wheelset [deg]", title="Roll while the wheelset hunts by 5 mm"
)
plt.savefig("step_the_fmu.png", dpi=150)

# at 5 mm an independent search finds the roll -3.696026826666e-4 rad
assert abs(min(roll) - -3.696026826666e-4) < 1e-9  # [rad]
