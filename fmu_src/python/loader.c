/* The library of the Python FMU that a host on Linux loads.  It loads that of PythonFMU, which lies beside it, and
 * hands every call on to it.  Three things it does itself, since PythonFMU ends the host's process without them:
 *
 *  - fmi2Instantiate gets the place of the resources as a path.  PythonFMU takes the host's URI without its "file://"
 *    for a path, so that it finds nothing in a folder with letters that a URI writes as %C3%A4, nor by file:/...;
 *  - a host that is no Python gets libpython, whose functions PythonFMU takes from the process;
 *  - the FMU's program is imported here first: PythonFMU calls what an import has not found, as without numpy.
 *
 * What cannot be loaded or found is written to the host's logger, and there is no instance.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifndef __x86_64__
#error "PythonFMU's library for Linux is that of x86_64"
#endif

#define EXPORT __attribute__((visibility("default")))
#define SENTENCE 1024
#define NEWEST 30 /* minor version of Python up to which libpython is looked for */
#define OLDEST 10

/* What fmi2FunctionTypes.h of FMI 2.0 defines, as far as it is used here. */
enum { FMI2_OK, FMI2_ERROR = 3, FMI2_FATAL = 4 };
typedef struct {
    void (*logger)(void *environment, const char *instance, int status, const char *category, const char *message, ...);
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
    void (*finished)(void *, int);
    void *environment;
} callbacks;
typedef void *(*instantiate)(const char *, int, const char *, const char *, const callbacks *, int, int);

static char folder[PATH_MAX];   /* of this library */
static char trouble[SENTENCE];  /* why PythonFMU's library cannot be used; empty if it can */
static instantiate create;

/* --- calls that are handed on ------------------------------------------------------------------------------------ */

/* Every function but fmi2Instantiate, and those that a host may call before it. */
#define FUNCTIONS(F) \
    F(fmi2SetDebugLogging) F(fmi2FreeInstance) F(fmi2SetupExperiment) F(fmi2EnterInitializationMode) \
    F(fmi2ExitInitializationMode) F(fmi2Terminate) F(fmi2Reset) F(fmi2GetReal) F(fmi2GetInteger) F(fmi2GetBoolean) \
    F(fmi2GetString) F(fmi2SetReal) F(fmi2SetInteger) F(fmi2SetBoolean) F(fmi2SetString) F(fmi2GetFMUstate) \
    F(fmi2SetFMUstate) F(fmi2FreeFMUstate) F(fmi2SerializedFMUstateSize) F(fmi2SerializeFMUstate) \
    F(fmi2DeSerializeFMUstate) F(fmi2GetDirectionalDerivative) F(fmi2SetRealInputDerivatives) \
    F(fmi2GetRealOutputDerivatives) F(fmi2DoStep) F(fmi2CancelStep) F(fmi2GetStatus) F(fmi2GetRealStatus) \
    F(fmi2GetIntegerStatus) F(fmi2GetBooleanStatus) F(fmi2GetStringStatus)

static int absent(void) { return FMI2_ERROR; }

/* A jump leaves all arguments where they are: no prototypes, and no time. */
#define JUMP(name) \
    __attribute__((visibility("hidden"))) void *target_##name = (void *)absent; \
    __asm__(".text\n.globl " #name "\n.type " #name ", @function\n" #name ": jmp *target_" #name "(%rip)\n" \
            ".size " #name ", .-" #name "\n");
FUNCTIONS(JUMP)

EXPORT const char *fmi2GetVersion(void) { return "2.0"; }
EXPORT const char *fmi2GetTypesPlatform(void) { return "default"; }

/* --- libpython --------------------------------------------------------------------------------------------------- */

/* Whether the process has Python's functions where a library finds them. */
static bool has_python(void) { return dlsym(RTLD_DEFAULT, "Py_IsInitialized") != NULL; }

static bool load_python(const char *path, int flags)
{
    return dlopen(path, RTLD_NOW | RTLD_GLOBAL | flags) && has_python();
}

/* libpython of the python3 that the host's PATH finds first: /usr/bin/python3.11 has /usr/lib/libpython3.11.so.1.0. */
static bool load_python_of_path(void)
{
    char program[PATH_MAX] = "", file[PATH_MAX + 64];
    const char *rest = getenv("PATH");
    while (rest && *rest) {
        size_t length = strcspn(rest, ":");
        snprintf(file, sizeof file, "%.*s/python3", (int)length, rest);
        rest += length + (rest[length] == ':');
        if (length && access(file, X_OK) == 0 && realpath(file, program))
            break;
        program[0] = 0;
    }
    char *name = rest && program[0] ? strrchr(program, '/') : NULL;
    int minor;
    if (!name || sscanf(name, "/python3.%d", &minor) != 1)
        return false;
    *name = 0; /* the folder bin */
    char *bin = strrchr(program, '/');
    if (bin)
        *bin = 0;
    snprintf(file, sizeof file, "%s/lib/libpython3.%d.so.1.0", program, minor);
    if (load_python(file, 0))
        return true;
    snprintf(file, sizeof file, "libpython3.%d.so.1.0", minor);
    return load_python(file, 0);
}

/* A host that is no Python: libpython that is in the process already, that of WRCONTACT_LIBPYTHON, of PATH, or any. */
static bool find_python(void)
{
    char name[64];
    const char *chosen = getenv("WRCONTACT_LIBPYTHON");
    for (int flags = RTLD_NOLOAD;; flags = 0) {
        if (!flags && chosen)
            return load_python(chosen, 0);
        if (!flags && load_python_of_path())
            return true;
        for (int minor = NEWEST; minor >= OLDEST; minor--) {
            snprintf(name, sizeof name, "libpython3.%d.so.1.0", minor);
            if (load_python(name, flags))
                return true;
        }
        if (!flags)
            return false;
    }
}

/* --- when the host loads this library ---------------------------------------------------------------------------- */

__attribute__((constructor)) static void load(void)
{
    Dl_info here;
    char path[PATH_MAX + 32];
    if (!dladdr((void *)load, &here) || !realpath(here.dli_fname, folder)) {
        snprintf(trouble, sizeof trouble, "the place of this library in the file system is not known");
        return;
    }
    *strrchr(folder, '/') = 0;
    if (!has_python() && !find_python()) {
        snprintf(trouble, sizeof trouble,
                 "this FMU runs in Python, and no library of Python 3.10 or newer, libpython3.*.so.1.0, was found; "
                 "install one (Debian: libpython3-dev), or name its file in the environment variable "
                 "WRCONTACT_LIBPYTHON, or take the native FMU");
        return;
    }
    snprintf(path, sizeof path, "%s/pythonfmu-export.so", folder);
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!library) {
        snprintf(trouble, sizeof trouble, "PythonFMU's library cannot be loaded: %s", dlerror());
        return;
    }
    create = (instantiate)dlsym(library, "fmi2Instantiate");
#define FIND(name) target_##name = dlsym(library, #name) ? dlsym(library, #name) : (void *)absent;
    FUNCTIONS(FIND)
}

/* --- where the resources are ------------------------------------------------------------------------------------- */

/* Whether a folder has the FMU's program. */
static bool is_resources(const char *place)
{
    char file[PATH_MAX + 32];
    snprintf(file, sizeof file, "%s/slavemodule.txt", place);
    return place[0] == '/' && access(file, R_OK) == 0;
}

static int digit(char c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* The path of file:///..., file://host/... or file:/..., each with %C3%A4 for letters; other texts as they are. */
static void decode(const char *location, char *place)
{
    const char *at = location;
    bool is_uri = strncmp(at, "file:", 5) == 0;
    if (is_uri && strncmp(at += 5, "//", 2) == 0)
        at += 2 + strcspn(at + 2, "/");
    size_t k = 0;
    for (; *at && k < PATH_MAX - 1; at++) {
        int high = is_uri && *at == '%' ? digit(at[1]) : -1, low = high < 0 ? -1 : digit(at[2]);
        place[k++] = low < 0 ? *at : (char)(16 * high + low);
        at += low < 0 ? 0 : 2;
    }
    place[k] = 0;
}

/* The place that the host names, decoded or as it is, else the one beside the folder of this library. */
static bool find_resources(const char *location, char *place)
{
    decode(location ? location : "", place);
    if (is_resources(place))
        return true;
    const char *plain = location && strncmp(location, "file://", 7) == 0 ? location + 7 : location;
    if (plain && is_resources(plain)) {
        snprintf(place, PATH_MAX, "%s", plain);
        return true;
    }
    char beside[PATH_MAX + 32];
    snprintf(beside, sizeof beside, "%s/../../resources", folder);
    return realpath(beside, place) && is_resources(place);
}

/* Whether a text is UTF-8, of which alone Python makes a text of its own. */
static bool is_utf8(const char *text)
{
    while (*text) {
        unsigned char first = (unsigned char)*text++;
        int more = first < 0x80 ? 0 : first < 0xC2 ? -1 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : first < 0xF5 ? 3 : -1;
        for (; more > 0 && (*text & 0xC0) == 0x80; more--)
            text++;
        if (more)
            return false;
    }
    return true;
}

/* A name without such letters for a path that PythonFMU would change or Python not read: it replaces "%20" and "file://". */
static void plain_name(char *place)
{
    if (is_utf8(place) && !strstr(place, "%20") && !strstr(place, "file://"))
        return;
    int open_folder = open(place, O_PATH | O_DIRECTORY | O_CLOEXEC); /* stays open as long as the process */
    if (open_folder >= 0)
        snprintf(place, PATH_MAX, "/proc/self/fd/%d", open_folder);
}

/* --- the FMU's program ------------------------------------------------------------------------------------------- */

/* Imports it as PythonFMU will; `trouble` says why that fails. */
static const char PROGRAM[] =
    "import importlib, sys\n"
    "place = place.decode()\n"
    "sys.path.insert(0, place)\n"
    "try:\n"
    "    with open(place + '/slavemodule.txt') as file:\n"
    "        importlib.import_module(file.readline().strip())\n"
    "    trouble = b''\n"
    "except BaseException as problem:\n"
    "    trouble = f'Python {sys.version.split()[0]} in {sys.prefix} cannot load the program of this FMU, which needs '\\\n"
    "        f'Python 3.10 or newer with numpy: {problem!r}'.encode('utf-8', 'replace')\n"
    "finally:\n"
    "    sys.path.remove(place)\n";

/* Functions of Python's C interface, as far as they are used here; all keep their form since Python 3.2. */
#define PYTHON(name, result, ...) result (*name)(__VA_ARGS__) = (result (*)(__VA_ARGS__))dlsym(RTLD_DEFAULT, #name)

/* Whether Python can load the program at a place; a sentence if not. */
static bool can_load(const char *place, char *sentence)
{
    PYTHON(Py_IsInitialized, int, void);
    PYTHON(Py_InitializeEx, void, int);
    PYTHON(PyEval_SaveThread, void *, void);
    PYTHON(PyGILState_Ensure, int, void);
    PYTHON(PyGILState_Release, void, int);
    PYTHON(PyDict_New, void *, void);
    PYTHON(PyDict_SetItemString, int, void *, const char *, void *);
    PYTHON(PyDict_GetItemString, void *, void *, const char *);
    PYTHON(PyBytes_FromString, void *, const char *);
    PYTHON(PyBytes_AsString, char *, void *);
    PYTHON(PyRun_String, void *, const char *, int, void *, void *);
    PYTHON(PyErr_Print, void, void);
    PYTHON(Py_DecRef, void, void *);
    if (!Py_IsInitialized()) {
        Py_InitializeEx(0); /* signals stay the host's */
        PyEval_SaveThread();
    }
    const int state = PyGILState_Ensure(), file_input = 257;
    void *names = PyDict_New(), *bytes = PyBytes_FromString(place);
    PyDict_SetItemString(names, "place", bytes);
    void *done = PyRun_String(PROGRAM, file_input, names, names);
    if (done)
        snprintf(sentence, SENTENCE, "%s", PyBytes_AsString(PyDict_GetItemString(names, "trouble")));
    else {
        PyErr_Print();
        snprintf(sentence, SENTENCE, "Python cannot run the program of this FMU; standard error has the reason");
    }
    Py_DecRef(done);
    Py_DecRef(bytes);
    Py_DecRef(names);
    PyGILState_Release(state);
    return sentence[0] == 0;
}

EXPORT void *fmi2Instantiate(const char *name, int type, const char *guid, const char *location,
                             const callbacks *functions, int visible, int logging)
{
    char place[PATH_MAX], sentence[SENTENCE + PATH_MAX];
    if (!create) {
        snprintf(sentence, sizeof sentence, "%s", trouble);
    } else if (!find_resources(location, place)) {
        snprintf(sentence, sizeof sentence,
                 "fmuResourceLocation is %s; permitted is the folder resources of this FMU, as a URI",
                 location ? location : "NULL");
    } else {
        plain_name(place);
        if (can_load(place, sentence))
            return create(name, type, guid, place, functions, visible, logging);
    }
    if (functions && functions->logger)
        functions->logger(functions->environment, name, FMI2_FATAL, "logStatusError", "%s", sentence);
    return NULL;
}
