//! `xtask-bindgen MODULE.wasm FOLDER` writes the JavaScript and types that belong to a compiled WebAssembly module.
//!
//! This program does what the program `wasm-bindgen` does. The program `wasm-bindgen` and the library of the same name
//! in the module must be of one version. This program depends on both, so the lock file keeps both at one version, and
//! a developer need not install `wasm-bindgen`.

use std::process::ExitCode;

use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [module, folder] = arguments.as_slice() else {
        eprintln!("usage: xtask-bindgen MODULE.wasm FOLDER");
        return ExitCode::from(2);
    };
    match make(module, folder) {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

/// Writes JavaScript for the web, which loads the module in the same way in browsers and in Node.
///
/// The module loses the names of its functions, which are a seventh of what a browser fetches. `wasm-opt` drops the
/// names too, so that the package of the tests is as large as the package that is published.
fn make(module: &str, folder: &str) -> Result<(), String> {
    let mut bindgen = Bindgen::new();
    let web = bindgen.input_path(module).out_name("raw").typescript(true).web(true);
    let web = web.map_err(|e| format!("{e:#}"))?;
    web.omit_default_module_path(true)
        .remove_name_section(true)
        .generate(folder)
        .map_err(|e| format!("{e:#}"))
}
