/* A host that is no Python: loads the library of a Python FMU and makes an instance for each location of its resources.
 *
 *     python_fmu_host <library> <guid> <reference of lateral_shift> <of right.area> [<location> or NULL] ...
 *
 * A line for each location: what right.area is after a step at 2 mm, or what the log says if there is no instance.
 */
#include <dlfcn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "fmi2FunctionTypes.h"

static void told(fmi2ComponentEnvironment where, fmi2String name, fmi2Status status, fmi2String category, fmi2String text, ...)
{
    va_list values;
    va_start(values, text);
    printf("%s %d %s: ", name, (int)status, category);
    vprintf(text, values);
    printf("\n");
    va_end(values);
    (void)where;
}

static void *library;

static void *found(const char *name)
{
    void *function = dlsym(library, name);
    if (!function) {
        fprintf(stderr, "%s is not in the library\n", name);
        exit(1);
    }
    return function;
}
#define CALL(name, ...) ((name##TYPE *)found(#name))(__VA_ARGS__)

int main(int count, char **words)
{
    library = dlopen(words[1], RTLD_NOW | RTLD_LOCAL);
    if (!library) {
        fprintf(stderr, "%s\n", dlerror());
        return 1;
    }
    if (strcmp(CALL(fmi2GetVersion), "2.0") || strcmp(CALL(fmi2GetTypesPlatform), "default"))
        return 1;
    const fmi2CallbackFunctions functions = {told, calloc, free, NULL, NULL};
    const fmi2ValueReference shift = (unsigned)atoi(words[3]), area = (unsigned)atoi(words[4]);
    for (int i = 5; i < count; i++) {
        const char *location = strcmp(words[i], "NULL") ? words[i] : NULL;
        fmi2Real value = 2e-3;
        fmi2Component one = CALL(fmi2Instantiate, "host", fmi2CoSimulation, words[2], location, &functions, 0, 0);
        if (!one)
            continue;
        if (CALL(fmi2SetupExperiment, one, 0, 0.0, 0.0, 0, 0.0) || CALL(fmi2EnterInitializationMode, one)
            || CALL(fmi2ExitInitializationMode, one) || CALL(fmi2SetReal, one, &shift, 1, &value)
            || CALL(fmi2DoStep, one, 0.0, 1e-3, 1) || CALL(fmi2GetReal, one, &area, 1, &value)
            || CALL(fmi2Terminate, one))
            return 1;
        CALL(fmi2FreeInstance, one);
        printf("%.17g\n", value);
    }
    fflush(stdout);
    _exit(0); /* PythonFMU's library reads freed memory when a process ends */
}
