"""An FMU of either version of the standard, driven call by call through FMPy."""

import shutil

from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave


class Fmu:
    """One instance; values by name."""

    def __init__(self, path, name="instance", folder=None):
        self.description = read_model_description(str(path), validate=True)
        self.folder = folder or extract(str(path))
        self.own_folder = folder is None
        self.three = self.description.fmiVersion == "3.0"
        self.variables = {v.name: v for v in self.description.modelVariables}
        kind = FMU3Slave if self.three else FMU2Slave
        self.fmu = kind(
            guid=self.description.guid,
            unzipDirectory=self.folder,
            modelIdentifier=self.description.coSimulation.modelIdentifier,
            instanceName=name,
        )
        self.fmu.instantiate()

    def initialize(self, stop_s=None, **values):
        self.set(**values)
        if self.three:
            self.fmu.enterInitializationMode(startTime=0.0, stopTime=stop_s)
        else:
            self.fmu.setupExperiment(startTime=0.0, stopTime=stop_s)
            self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()
        return self

    def set(self, **values):
        self.set_all({name.replace("__", "."): value for name, value in values.items()})

    def set_all(self, values):
        for name, value in values.items():
            variable = self.variables[name]
            reference = [variable.valueReference]
            if variable.type in ("Boolean",):
                self.fmu.setBoolean(reference, [bool(value)])
            elif variable.type == "Int32":
                self.fmu.setInt32(reference, [value])
            elif variable.type == "Enumeration" and self.three:
                self.fmu.setInt64(reference, [value])
            elif variable.type in ("Integer", "Enumeration"):
                self.fmu.setInteger(reference, [value])
            elif self.three:
                self.fmu.setFloat64(reference, [value])
            else:
                self.fmu.setReal(reference, [value])

    def get(self, *names):
        references = [self.variables[name].valueReference for name in names]
        get = self.fmu.getFloat64 if self.three else self.fmu.getReal
        return list(get(references))

    def step(self, t_s, step_s):
        self.fmu.doStep(currentCommunicationPoint=t_s, communicationStepSize=step_s)

    def close(self, terminate=True):
        if terminate:
            self.fmu.terminate()
        self.fmu.freeInstance()
        if self.own_folder:
            shutil.rmtree(self.folder, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, kind, *_):
        self.close(terminate=kind is None)
