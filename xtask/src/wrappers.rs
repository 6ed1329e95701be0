//! Tests the C++ header and the C# file over the C interface: compiles their examples and the guide of game loops with
//! all warnings as errors, and runs them. The tests of the wrappers are part of `cargo xtask c`.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::built;
use crate::c_build::{Build, SANITIZERS, SYSTEM, WARNINGS};
use crate::command::run_quietly;
use crate::guide;
use crate::step::Done;
use crate::tools;

const EXAMPLE: &str = "examples/cpp/game_loop.cpp";
const GUIDE: &str = "docs/guides/game_loop.md";

/// Tests the C++ example, the checks of the wrapper and the guide, as C++17 and C++20, and lets `fenderline replay`
/// replay the example's dump.
pub(crate) fn cpp() -> Result<Done, String> {
    if let Err(missing) = tools::c_compiler() {
        return Ok(Done::NotRun(missing));
    }
    let build = Build::new("cpp")?;
    let done = cpp_in(&build);
    build.remove()?;
    done.map(|()| Done::Good)
}

fn cpp_in(build: &Build) -> Result<(), String> {
    let text = std::fs::read_to_string(GUIDE).map_err(|e| format!("{GUIDE}: {e}"))?;
    let guide = guide::Guide::read(&text, "cpp")?;
    let guide_source = build.folder.join("guide.cpp");
    std::fs::write(&guide_source, &guide.program)
        .map_err(|e| format!("{}: {e}", guide_source.display()))?;
    let dump = build.folder.join("last_steps.dump");
    for standard in ["c++17", "c++20"] {
        let example = compile(build, Path::new(EXAMPLE), standard)?;
        run_quietly(Command::new(&example).arg(&dump))?;
        let checks = compile(build, Path::new("crates/capi/tests/wrapper.cpp"), standard)?;
        run_quietly(&mut Command::new(&checks))?;
        let program = compile(build, &guide_source, standard)?;
        guide.expects(&run_quietly(&mut Command::new(&program))?)?;
    }
    println!("{EXAMPLE}, wrapper.cpp and {GUIDE}: as C++17 and C++20 under sanitizers");
    let mut program = Command::new(built::program("release")?);
    let replayed = run_quietly(program.arg("replay").arg(&dump))?;
    if !replayed.contains("all steps gave the same bits as recorded") {
        return Err(format!("fenderline replay of the example's dump:\n{replayed}"));
    }
    println!("fenderline replay: {}", replayed.lines().next().unwrap_or_default());
    Ok(())
}

fn compile(build: &Build, source: &Path, standard: &str) -> Result<PathBuf, String> {
    let stem = source.file_stem().unwrap_or_default().to_string_lossy();
    let program = build.folder.join(format!("{stem}-{standard}"));
    let mut cpp = Command::new("c++");
    cpp.arg(format!("-std={standard}")).arg("-g").args(WARNINGS).args(SANITIZERS);
    cpp.arg("-Iinclude").arg(source).arg(&build.library).args(SYSTEM);
    run_quietly(cpp.arg("-o").arg(&program))?;
    Ok(program)
}

/// Checks that the C# example prints what the C++ example prints.
pub(crate) fn csharp() -> Result<Done, String> {
    for missing in [tools::c_compiler(), tools::mono()] {
        if let Err(missing) = missing {
            return Ok(Done::NotRun(missing));
        }
    }
    let build = Build::new("csharp")?;
    let done = csharp_in(&build);
    build.remove()?;
    done.map(|()| Done::Good)
}

fn csharp_in(build: &Build) -> Result<(), String> {
    let program = build.folder.join("game_loop.exe");
    // C# 7 is what .NET Standard 2.0 and Unity have.
    let mut compiler = Command::new("mcs");
    compiler.args(["-langversion:7", "-warnaserror", "-nologo"]);
    compiler.arg(format!("-out:{}", program.display()));
    run_quietly(compiler.args(["bindings/csharp/Fenderline.cs", "examples/csharp/GameLoop.cs"]))?;
    let mut mono = Command::new("mono");
    let folder = build.library.parent().unwrap_or(Path::new("."));
    let printed = run_quietly(mono.arg(&program).env("LD_LIBRARY_PATH", folder))?;
    let cpp = compile(build, Path::new(EXAMPLE), "c++17")?;
    let expected = run_quietly(&mut Command::new(&cpp))?;
    if printed != expected {
        return Err(format!("C# printed\n{printed}\nand C++\n{expected}"));
    }
    functions_exist()?;
    println!("examples/csharp/GameLoop.cs under Mono: prints what the C++ example prints");
    Ok(())
}

/// Checks that the header has every function that the C# file imports, and that both have the same version of the
/// interface.
fn functions_exist() -> Result<(), String> {
    let read = |file: &str| std::fs::read_to_string(file).map_err(|e| format!("{file}: {e}"));
    let (own, header) = (read("bindings/csharp/Fenderline.cs")?, read("include/fenderline.h")?);
    let imported = own.split("static extern ").skip(1);
    for name in imported.filter_map(|rest| rest.split('(').next()?.rsplit(' ').next()) {
        if !header.contains(&format!(" {name}(")) && !header.contains(&format!("*{name}(")) {
            return Err(format!("Fenderline.cs imports {name}, which the header does not declare"));
        }
    }
    let number = |text: &str, before: &str| {
        let rest = text.split(before).nth(1)?;
        Some(rest.trim().chars().take_while(char::is_ascii_digit).collect::<String>())
    };
    let versions =
        [number(&header, "#define FL_ABI_VERSION "), number(&own, "const uint AbiVersion = ")];
    if versions[0].is_none() || versions[0] != versions[1] {
        return Err(format!("interface versions of header and Fenderline.cs: {versions:?}"));
    }
    Ok(())
}
