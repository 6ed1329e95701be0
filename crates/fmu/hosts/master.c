/*
 * A small master for FMI 2.0: loads the library of an unpacked FMU, makes an instance, steps it, and prints the bits of
 * some variables after each step. It is compiled for Linux and for Windows, to compare what the two libraries of one FMU
 * compute.
 *
 *     master LIBRARY RESOURCES_URI GUID STEP_S STEPS VALUE_REFERENCE...
 */
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef _WIN32
#include <windows.h>
typedef HMODULE library;
#else
#include <dlfcn.h>
typedef void *library;
#endif

enum { OK = 0, CO_SIMULATION = 1, MOST_VALUES = 4096 };

typedef void (*logger)(void *, const char *, int, const char *, const char *, ...);
typedef struct {
    logger log;
    void *(*allocate)(size_t, size_t);
    void (*free)(void *);
    void (*step_finished)(void *, int);
    void *environment;
} callbacks;

typedef void *(*instantiate)(const char *, int, const char *, const char *, const callbacks *, int, int);
typedef int (*setup_experiment)(void *, int, double, double, int, double);
typedef int (*plain)(void *);
typedef int (*do_step)(void *, double, double, int);
typedef int (*get_real)(void *, const unsigned *, size_t, double *);
typedef void (*free_instance)(void *);

static void fail(const char *what)
{
    fprintf(stderr, "failed: %s\n", what);
    exit(1);
}

static void message(void *environment, const char *instance, int status, const char *category, const char *text, ...)
{
    va_list rest;
    (void)environment;
    fprintf(stderr, "%s, status %d, %s: ", instance, status, category);
    va_start(rest, text);
    vfprintf(stderr, text, rest);
    va_end(rest);
    fputc('\n', stderr);
}

static library load(const char *path)
{
#ifdef _WIN32
    char full[4096];
    if (GetFullPathNameA(path, sizeof full, full, NULL) == 0)
        fail("GetFullPathName");
    return LoadLibraryA(full);
#else
    return dlopen(path, RTLD_NOW | RTLD_LOCAL);
#endif
}

/* The address of a function, copied bit by bit: ISO C converts no pointer to data into one to a function. */
static void find(library from, const char *name, void *function)
{
#ifdef _WIN32
    FARPROC address = GetProcAddress(from, name);
#else
    void *address = dlsym(from, name);
#endif
    if (address == NULL)
        fail(name);
    memcpy(function, &address, sizeof address);
}

int main(int count, char **arguments)
{
    static unsigned references[MOST_VALUES];
    static double values[MOST_VALUES];
    callbacks functions = {message, calloc, free, NULL, NULL};
    instantiate make;
    setup_experiment set_up;
    plain enter, leave, terminate;
    do_step step;
    get_real get;
    free_instance release;
    library fmu;
    void *instance;
    double step_s;
    long steps, number;
    size_t index, many;

    if (count < 7 || count - 6 > MOST_VALUES)
        fail("usage: master LIBRARY RESOURCES_URI GUID STEP_S STEPS VALUE_REFERENCE...");
    step_s = strtod(arguments[4], NULL);
    steps = strtol(arguments[5], NULL, 10);
    many = (size_t)(count - 6);
    for (index = 0; index < many; index++)
        references[index] = (unsigned)strtoul(arguments[6 + index], NULL, 10);
    fmu = load(arguments[1]);
    if (fmu == NULL)
        fail("the library cannot be loaded");
    find(fmu, "fmi2Instantiate", &make);
    find(fmu, "fmi2SetupExperiment", &set_up);
    find(fmu, "fmi2EnterInitializationMode", &enter);
    find(fmu, "fmi2ExitInitializationMode", &leave);
    find(fmu, "fmi2DoStep", &step);
    find(fmu, "fmi2GetReal", &get);
    find(fmu, "fmi2Terminate", &terminate);
    find(fmu, "fmi2FreeInstance", &release);
    instance = make("ship", CO_SIMULATION, arguments[3], arguments[2], &functions, 0, 0);
    if (instance == NULL)
        fail("fmi2Instantiate");
    if (set_up(instance, 0, 0.0, 0.0, 0, 0.0) != OK || enter(instance) != OK || leave(instance) != OK)
        fail("initialization");
    for (number = 0; number < steps; number++) {
        if (step(instance, (double)number * step_s, step_s, 1) != OK)
            fail("fmi2DoStep");
        if (get(instance, references, many, values) != OK)
            fail("fmi2GetReal");
        for (index = 0; index < many; index++) {
            uint64_t bits;
            memcpy(&bits, &values[index], sizeof bits);
            printf("%08lx%08lx ", (unsigned long)(bits >> 32), (unsigned long)(bits & 0xffffffffu));
        }
        printf("\n");
    }
    if (terminate(instance) != OK)
        fail("fmi2Terminate");
    release(instance);
    return 0;
}
