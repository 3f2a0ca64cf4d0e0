/* The wheelset of wheelset.py as an FMU of FMI 2.0 for model exchange: its equations, and a solver of the importer's.
 *
 * exchange.py writes variables.h from the tables of wheelset.py: an enumeration of all variables by value reference, which is their
 * place in `values`, and the start values of the parameters.
 */
#include <stdlib.h>
#include <string.h>

#include "fmi2Functions.h"
#include "variables.h"

enum { PLACES = 4, STATES = distance - lateral_shift + 1 };     /* places, their rates, the wheel's rotation, the distance */
static const double GRAVITY = 9.81;

typedef struct {
    double values[VARIABLES];
} wheelset;

/* --- the model ---------------------------------------------------------------------------------------------- */

/* sin(x) and cos(x) by their series, exact for a yaw below 0.5 rad: no mathematical library is needed. */
static void turn_by(double x, double *sine, double *cosine)
{
    double term = 1.0, sums[2] = {1.0, 0.0};
    for (int n = 1; n < 18; n += 1)
    {
        term *= (n % 2 ? x : -x) / n;
        sums[n % 2] += term;
    }
    *cosine = sums[0], *sine = sums[1];
}

static void start(wheelset *self)
{
    double *v = self->values;
    memset(v + lateral_shift, 0, STATES * sizeof(double));
    v[lateral_shift] = v[start_lateral_shift];
    v[vertical_shift] = v[start_vertical_shift];
    v[roll] = v[start_roll];
    v[yaw] = v[start_yaw];
    v[lateral_velocity] = v[start_lateral_velocity];
    v[wheel_rate] = v[start_wheel_rate] != 0.0 ? v[start_wheel_rate] : v[frame_speed] / v[nominal_radius];
}

/* Accelerations and the other rates of the states, the speed, and the curvature of the track. */
static void evaluate(wheelset *self)
{
    double *v = self->values, *rates = v + VARIABLES - STATES;
    const double V = v[frame_speed], W = v[load], k = v[curve_curvature], length = v[transition_length];
    const double share = (v[distance] - v[curve_start]) / length, inside = share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share;
    const double bend = k * inside, grows = 0.0 <= share && share < 1.0 ? k / length : 0.0;
    const double thrown = (1.0 - v[canted]) * W / GRAVITY * V * V, gyroscopic = v[inertia_pitch] * V / v[nominal_radius];
    const double turn = v[yaw], arm2 = v[box_distance] * v[box_distance], ahead = v[half_wheelbase];
    const double stiffness[PLACES] = {2.0 * v[lateral_stiffness], 2.0 * v[vertical_stiffness], 2.0 * v[vertical_stiffness] * arm2,
                                      2.0 * v[longitudinal_stiffness] * arm2};
    const double damping[PLACES] = {2.0 * v[lateral_damping], 2.0 * v[vertical_damping], 2.0 * v[vertical_damping] * arm2,
                                    2.0 * v[longitudinal_damping] * arm2};
    const double stretched[PLACES] = {v[lateral_shift], v[vertical_shift] - v[start_vertical_shift], v[roll], turn + ahead * bend};
    const double frame[PLACES] = {0.0, 0.0, 0.0, -ahead * grows * V};       /* how fast its end of the springs moves */
    double sine, cosine;
    turn_by(turn, &sine, &cosine);
    const double inertia[PLACES] = {v[mass], v[mass], v[inertia_roll], v[inertia_yaw]};
    const double pushes[PLACES] = {
        v[force_y] - thrown * bend,
        v[force_z] + W,
        v[moment_x] * cosine + v[moment_y] * sine - gyroscopic * (v[yaw_rate] + V * bend),
        v[moment_z] + gyroscopic * v[roll_rate] - v[inertia_yaw] * V * V * grows};
    for (int i = 0; i < PLACES; i += 1)
    {
        const double rate = v[lateral_velocity + i];
        rates[i] = rate;
        rates[PLACES + i] = (pushes[i] - stiffness[i] * stretched[i] - damping[i] * (rate - frame[i])) / inertia[i];
    }
    rates[wheel_rate - lateral_shift] = v[driving_torque] / v[inertia_pitch];
    rates[distance - lateral_shift] = v[speed] = V;
    v[track_curvature] = bend;
}

/* --- FMI ---------------------------------------------------------------------------------------------------- */

const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char *fmi2GetVersion(void) { return fmi2Version; }

fmi2Status fmi2Reset(fmi2Component c)
{
    wheelset *self = c;
    memset(self->values, 0, sizeof self->values);
    memcpy(self->values, START, sizeof START);
    start(self);
    return fmi2OK;
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions *callbacks, fmi2Boolean visible, fmi2Boolean logging)
{
    (void)name, (void)resources, (void)callbacks, (void)visible, (void)logging;
    wheelset *self = type == fmi2ModelExchange && guid && strcmp(guid, GUID) == 0 ? calloc(1, sizeof *self) : NULL;
    if (self)
        fmi2Reset(self);
    return self;
}

void fmi2FreeInstance(fmi2Component c) { free(c); }

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference references[], size_t count, const fmi2Real values[])
{
    wheelset *self = c;
    for (size_t i = 0; i < count; i += 1)
    {
        if (references[i] >= lateral_shift)
            return fmi2Error;       /* a state is set by fmi2SetContinuousStates */
        self->values[references[i]] = values[i];
        if (references[i] < force_y)
            start(self);
    }
    return fmi2OK;
}

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference references[], size_t count, fmi2Real values[])
{
    wheelset *self = c;
    evaluate(self);
    for (size_t i = 0; i < count; i += 1)
    {
        if (references[i] >= VARIABLES)
            return fmi2Error;
        values[i] = self->values[references[i]];
    }
    return fmi2OK;
}

fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real states[], size_t count)
{
    wheelset *self = c;
    memcpy(states, self->values + lateral_shift, STATES * sizeof(double));
    return count == STATES ? fmi2OK : fmi2Error;
}

fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real states[], size_t count)
{
    wheelset *self = c;
    memcpy(self->values + lateral_shift, states, STATES * sizeof(double));
    return count == STATES ? fmi2OK : fmi2Error;
}

fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real rates[], size_t count)
{
    wheelset *self = c;
    evaluate(self);
    memcpy(rates, self->values + VARIABLES - STATES, STATES * sizeof(double));
    return count == STATES ? fmi2OK : fmi2Error;
}

fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real nominals[], size_t count)
{
    (void)c;
    memcpy(nominals, NOMINAL, sizeof NOMINAL);
    return count == STATES ? fmi2OK : fmi2Error;
}

fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *events)
{
    (void)c;
    *events = (fmi2EventInfo){fmi2False, fmi2False, fmi2False, fmi2False, fmi2False, 0.0};
    return fmi2OK;
}

fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean never_back, fmi2Boolean *event, fmi2Boolean *end)
{
    (void)c, (void)never_back;
    *event = *end = fmi2False;
    return fmi2OK;
}

/* What changes nothing, and what this example does not have. */
#define FUNCTION(NAME, STATUS, ...) \
    fmi2Status NAME(fmi2Component c, __VA_ARGS__) { return c ? STATUS : fmi2Error; }
#define MODE(NAME) \
    fmi2Status NAME(fmi2Component c) { return c ? fmi2OK : fmi2Error; }

MODE(fmi2EnterInitializationMode)
MODE(fmi2ExitInitializationMode)
MODE(fmi2EnterEventMode)
MODE(fmi2EnterContinuousTimeMode)
MODE(fmi2Terminate)
FUNCTION(fmi2SetTime, fmi2OK, fmi2Real time)
FUNCTION(fmi2SetupExperiment, fmi2OK, fmi2Boolean with, fmi2Real tolerance, fmi2Real from, fmi2Boolean stops, fmi2Real stop)
FUNCTION(fmi2SetDebugLogging, fmi2OK, fmi2Boolean on, size_t n, const fmi2String names[])
FUNCTION(fmi2GetEventIndicators, n ? fmi2Error : fmi2OK, fmi2Real values[], size_t n)
FUNCTION(fmi2GetInteger, n ? fmi2Error : fmi2OK, const fmi2ValueReference r[], size_t n, fmi2Integer values[])
FUNCTION(fmi2GetBoolean, n ? fmi2Error : fmi2OK, const fmi2ValueReference r[], size_t n, fmi2Boolean values[])
FUNCTION(fmi2GetString, n ? fmi2Error : fmi2OK, const fmi2ValueReference r[], size_t n, fmi2String values[])
FUNCTION(fmi2SetInteger, n ? fmi2Error : fmi2OK, const fmi2ValueReference r[], size_t n, const fmi2Integer values[])
FUNCTION(fmi2SetBoolean, n ? fmi2Error : fmi2OK, const fmi2ValueReference r[], size_t n, const fmi2Boolean values[])
FUNCTION(fmi2SetString, n ? fmi2Error : fmi2OK, const fmi2ValueReference r[], size_t n, const fmi2String values[])
FUNCTION(fmi2GetFMUstate, fmi2Error, fmi2FMUstate *state)
FUNCTION(fmi2SetFMUstate, fmi2Error, fmi2FMUstate state)
FUNCTION(fmi2FreeFMUstate, fmi2Error, fmi2FMUstate *state)
FUNCTION(fmi2SerializedFMUstateSize, fmi2Error, fmi2FMUstate state, size_t *size)
FUNCTION(fmi2SerializeFMUstate, fmi2Error, fmi2FMUstate state, fmi2Byte bytes[], size_t size)
FUNCTION(fmi2DeSerializeFMUstate, fmi2Error, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state)
FUNCTION(fmi2GetDirectionalDerivative, fmi2Error, const fmi2ValueReference u[], size_t n, const fmi2ValueReference k[], size_t m,
         const fmi2Real seed[], fmi2Real sensitivity[])
