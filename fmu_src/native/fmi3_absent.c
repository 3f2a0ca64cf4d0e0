/* FMI 3.0: functions for what this FMU does not have; each is refused with the reason. */
#include "fmi3_instance.h"

#define NO_VALUES(TYPE, C_TYPE)                                                                                             \
    fmi3Status fmi3Get##TYPE(fmi3Instance self, const fmi3ValueReference references[], size_t count, C_TYPE values[],       \
                             size_t value_count)                                                                            \
    {                                                                                                                       \
        (void)references, (void)values, (void)value_count;                                                                  \
        return self && count == 0 ? fmi3OK : fmi3_refuse(self, "fmi3Get" #TYPE, "there are no variables of this type");          \
    }                                                                                                                       \
    fmi3Status fmi3Set##TYPE(fmi3Instance self, const fmi3ValueReference references[], size_t count, const C_TYPE values[], \
                             size_t value_count)                                                                            \
    {                                                                                                                       \
        (void)references, (void)values, (void)value_count;                                                                  \
        return self && count == 0 ? fmi3OK : fmi3_refuse(self, "fmi3Set" #TYPE, "there are no variables of this type");          \
    }

NO_VALUES(Float32, fmi3Float32)
NO_VALUES(Int8, fmi3Int8)
NO_VALUES(UInt8, fmi3UInt8)
NO_VALUES(Int16, fmi3Int16)
NO_VALUES(UInt16, fmi3UInt16)
NO_VALUES(UInt32, fmi3UInt32)
NO_VALUES(Int64, fmi3Int64)

/* A function of FMI 3 that this FMU declares no capability for. */
#define NOT_HERE(NAME, REASON, ...)                                 \
    fmi3Status NAME(fmi3Instance self, __VA_ARGS__)                 \
    {                                                               \
        return fmi3_refuse(self, #NAME, REASON);                         \
    }
/* The same for a list of `n` values, of which there may be none. */
#define NO_LIST(NAME, REASON, ...)                                  \
    fmi3Status NAME(fmi3Instance self, __VA_ARGS__)                 \
    {                                                               \
        return self && n == 0 ? fmi3OK : fmi3_refuse(self, #NAME, REASON); \
    }

#define TYPELESS "there are no variables of this type"
#define CLOCKLESS "there are no clocks"

NO_LIST(fmi3GetBinary, TYPELESS, reference_list r, size_t n, size_t sizes[], fmi3Binary values[], size_t m)
NO_LIST(fmi3SetBinary, TYPELESS, reference_list r, size_t n, const size_t sizes[], const fmi3Binary values[], size_t m)
NO_LIST(fmi3GetClock, CLOCKLESS, reference_list r, size_t n, fmi3Clock values[])
NO_LIST(fmi3SetClock, CLOCKLESS, reference_list r, size_t n, const fmi3Clock values[])
NOT_HERE(fmi3GetIntervalDecimal, CLOCKLESS, reference_list r, size_t n, fmi3Float64 i[], fmi3IntervalQualifier q[])
NOT_HERE(fmi3GetIntervalFraction, CLOCKLESS, reference_list r, size_t n, fmi3UInt64 c[], fmi3UInt64 d[],
         fmi3IntervalQualifier q[])
NOT_HERE(fmi3GetShiftDecimal, CLOCKLESS, reference_list r, size_t n, fmi3Float64 s[])
NOT_HERE(fmi3GetShiftFraction, CLOCKLESS, reference_list r, size_t n, fmi3UInt64 c[], fmi3UInt64 d[])
NOT_HERE(fmi3SetIntervalDecimal, CLOCKLESS, reference_list r, size_t n, const fmi3Float64 i[])
NOT_HERE(fmi3SetIntervalFraction, CLOCKLESS, reference_list r, size_t n, const fmi3UInt64 c[], const fmi3UInt64 d[])
NOT_HERE(fmi3SetShiftDecimal, CLOCKLESS, reference_list r, size_t n, const fmi3Float64 s[])
NOT_HERE(fmi3SetShiftFraction, CLOCKLESS, reference_list r, size_t n, const fmi3UInt64 c[], const fmi3UInt64 d[])
NOT_HERE(fmi3ActivateModelPartition, CLOCKLESS, fmi3ValueReference clock, fmi3Float64 time)
NOT_HERE(fmi3GetNumberOfVariableDependencies, "dependencies are in the model description", fmi3ValueReference r, size_t *n)
NOT_HERE(fmi3GetVariableDependencies, "dependencies are in the model description", fmi3ValueReference r, size_t e[],
         fmi3ValueReference i[], size_t f[], fmi3DependencyKind k[], size_t n)
NOT_HERE(fmi3GetOutputDerivatives, "there are no output derivatives", reference_list r, size_t n, const fmi3Int32 orders[],
         fmi3Float64 values[], size_t m)

fmi3Status fmi3EnterStepMode(fmi3Instance self)
{
    return fmi3_refuse(self, "fmi3EnterStepMode", "there is no event mode in co-simulation");
}
