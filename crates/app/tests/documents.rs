//! The documents of a run: title page, workbook, PDF.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use crate::support;

use calamine::{Data, Reader as _, Xlsx};
use fenderline_contact::number::greater;
use std::collections::BTreeMap;
use std::io::Cursor;

use support::{Workplace, contains_all};

type Book = Xlsx<Cursor<Vec<u8>>>;

fn book(place: &Workplace, name: &str) -> Book {
    Xlsx::new(Cursor::new(place.read(name))).expect("a workbook")
}

/// The cells of a sheet.
fn cells(book: &mut Book, sheet: &str) -> Vec<Vec<Data>> {
    let range = book.worksheet_range(sheet).unwrap_or_else(|e| panic!("{sheet}: {e}"));
    range.rows().map(<[Data]>::to_vec).collect()
}

/// The column of a sheet whose head is in row 1.
fn column(sheet: &[Vec<Data>], head: &str) -> usize {
    sheet[0].iter().position(|cell| cell == head).unwrap_or_else(|| panic!("no column {head}"))
}

/// Cells of the workbook are those of the csv file, bit for bit: both are the shortest text that reads back to the number.
#[test]
fn the_time_series_of_the_workbook_are_those_of_the_csv_files() {
    let place = Workplace::new("workbook_series");
    let run = place.run(&[
        "run",
        "berth.toml",
        "--allow-failures",
        "--xlsx",
        "berth.xlsx",
        "--sheets",
        "fenders, energy",
    ]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let mut book = book(&place, "berth.xlsx");
    for table in ["fenders", "energy"] {
        let sheet = cells(&mut book, &format!("{table} by time"));
        let text = place.text(&format!("out/berth/{table}.csv"));
        let lines: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
        let heads: Vec<String> = sheet[0].iter().map(ToString::to_string).collect();
        assert_eq!(heads, lines[0]);
        // Below the heads are the units.
        assert_eq!(sheet.len() - 2, lines.len() - 1, "{table}");
        assert!(sheet.len() > 100, "{table}");
        for (row, line) in sheet[2..].iter().zip(&lines[1..]) {
            for (cell, field) in row.iter().zip(line) {
                match cell {
                    Data::Float(value) => {
                        let theirs: f64 = field.parse().expect("a number");
                        assert_eq!(value.to_bits(), theirs.to_bits(), "{field}");
                    }
                    Data::Int(value) => assert_eq!(value.to_string(), *field),
                    Data::Bool(value) => assert_eq!(value.to_string(), *field),
                    Data::String(value) => assert_eq!(value, field),
                    Data::Empty => assert_eq!(*field, ""),
                    other => panic!("{other:?} for {field}"),
                }
            }
        }
    }
}

#[test]
fn the_sheets_of_the_workbook_have_the_numbers_of_the_summary() {
    let place = Workplace::new("workbook_sheets");
    let arguments = ["--allow-failures", "--xlsx", "b.xlsx", "--client", "=1+1", "--revision", "2"];
    let run = place.run(&[&["run", "berth.toml"], &arguments[..]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("workbook: b.xlsx"), "{}", run.stdout);
    let summary = place.json("out/berth/summary.json");
    let mut book = book(&place, "b.xlsx");
    assert_eq!(
        book.sheet_names(),
        ["Summary", "Findings", "Fenders", "Berthing", "Contacts"],
        "no lines, no time series"
    );
    let first = cells(&mut book, "Summary");
    let value = |name: &str| first.iter().find(|row| row[0] == name).map(|row| row[1].clone());
    assert_eq!(value("Verdict"), Some(Data::String("Fender failed".into())));
    // A text, never a formula.
    assert_eq!(value("Client"), Some(Data::String("=1+1".into())));
    assert_eq!(value("Revision"), Some(Data::String("2".into())));
    assert_eq!(summary["report"]["client"], "=1+1");

    let fenders = cells(&mut book, "Fenders");
    let reaction = column(&fenders, "Reaction");
    assert_eq!(fenders[1][reaction], "kN");
    let of = |name: &str| fenders.iter().find(|row| row[0] == name).expect("a fender").clone();
    let touched = summary["fenders"].as_array().expect("fenders").iter();
    let mut compared = 0;
    for fender in touched.filter(|fender| fender["peak_reaction_n"].is_number()) {
        let ours = of(fender["name"].as_str().expect("a name"))[reaction].clone();
        let theirs = fender["peak_reaction_n"].as_f64().expect("a number") / 1e3;
        assert_eq!(ours, Data::Float(theirs));
        compared += 1;
    }
    assert_eq!(compared, 2);
    assert_eq!(of("idle")[column(&fenders, "Touched")], Data::Bool(false));
    let findings = cells(&mut book, "Findings");
    let told = summary["verdict"]["findings"][0]["text"].as_str().expect("a finding");
    assert_eq!(findings[2][3], Data::String(told.to_owned()));
}

/// Rows of a csv file as maps of column and field.
fn records(text: &str) -> Vec<BTreeMap<String, String>> {
    let mut lines = text.lines();
    let heads: Vec<&str> = lines.next().expect("a head").split(',').collect();
    lines
        .map(|line| {
            let fields = heads.iter().zip(line.split(','));
            fields.map(|(head, field)| ((*head).to_owned(), field.to_owned())).collect()
        })
        .collect()
}

fn largest(rows: &[BTreeMap<String, String>], column: &str) -> f64 {
    rows.iter().map(|row| row[column].parse::<f64>().expect("a number").abs()).fold(0.0, greater)
}

/// The scenario has two panels on two cones each, with a tension, a shear and a weight chain.
#[test]
fn panels_and_chains_are_in_tables_report_and_workbook() {
    let place = Workplace::new("documents_panels");
    let name = "chains_hold_a_panel_that_turns";
    let text = include_str!("../../../scenarios/berth/chains_hold_a_panel_that_turns.toml");
    place.write(&format!("{name}.toml"), text.as_bytes());
    let run = place.run(&["run", &format!("{name}.toml"), "--xlsx", "p.xlsx"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let summary = place.json(&format!("out/{name}/summary.json"));
    let fender = &summary["fenders"][1];
    assert_eq!(fender["name"], "forward");

    let of_forward = |table: &str| {
        let rows = records(&place.text(&format!("out/{name}/{table}.csv")));
        rows.into_iter().filter(|row| row["fender"] == "forward").collect::<Vec<_>>()
    };
    let panels = of_forward("panels");
    let panel = &fender["panel"];
    let number = |value: &serde_json::Value| value.as_f64().expect("a number");
    assert_eq!(largest(&panels, "peak_tilt_rad"), number(&panel["peak_tilt_rad"]).abs());
    assert_eq!(largest(&panels, "peak_moment_nm"), number(&panel["peak_moment_nm"]).abs());
    let cones = panel["cones"].as_array().expect("cones");
    let most_m = cones.iter().map(|cone| number(&cone["peak_deflection_m"])).fold(0.0, greater);
    assert_eq!(largest(&panels, "peak_cone_deflection_m"), most_m);
    // The middle and the turn at the start of a step give each cone, which is within the peaks of the steps before and in it.
    for row in &panels {
        let value = |column: &str| row[column].parse::<f64>().expect("a number");
        for at_m in [-1.0, 1.4] {
            let cone_m = value("deflection_m") + at_m * value("tilt_rad");
            assert!(cone_m <= value("peak_cone_deflection_m") + 1e-12, "{row:?}");
            assert!(cone_m >= value("least_cone_deflection_m") - 1e-12, "{row:?}");
        }
    }
    let worst = &cones[0];
    assert_eq!(
        number(&worst["share_of_rated_deflection"]),
        number(&fender["share_of_rated_deflection"])
    );
    assert_eq!(number(&worst["share_of_rated_energy"]), number(&fender["share_of_rated_energy"]));

    let chains = of_forward("chains");
    for (chain, kind) in
        fender["chains"].as_array().expect("chains").iter().zip(["tension", "shear", "weight"])
    {
        let own: Vec<_> = chains.iter().filter(|row| row["kind"] == kind).cloned().collect();
        assert_eq!(largest(&own, "peak_tension_n"), number(&chain["peak_tension_n"]), "{kind}");
        assert!(own.iter().all(|row| row["parted"] == "false"));
    }

    let mut book = book(&place, "p.xlsx");
    let sheet = cells(&mut book, "Panels");
    assert_eq!(sheet.len(), 2 + 4, "two panels on two cones");
    assert_eq!(sheet[4][column(&sheet, "Fender")], "forward");
    assert_eq!(
        sheet[4][column(&sheet, "Deflection")],
        Data::Float(number(&worst["peak_deflection_m"]) * 1e3)
    );
    let sheet = cells(&mut book, "Chains");
    assert_eq!(sheet.len(), 2 + 6, "two fenders with three chains");
    let peak_n = number(&fender["chains"][0]["peak_tension_n"]);
    assert_eq!(sheet[5][column(&sheet, "Peak tension")], Data::Float(peak_n / 1e3));
    let break_n = number(&fender["chains"][0]["break_load_n"]);
    assert_eq!(
        (sheet[5][column(&sheet, "Break load")].clone(), break_n),
        (Data::Float(400.0), 400e3)
    );
    contains_all(
        &place.text(&format!("out/{name}/report.html")),
        &[
            "<h3>Panels</h3>",
            "<h3>Chains</h3>",
            "Panel of fender forward, number 2",
            "Chain of highest share",
            "Largest moment of a panel",
        ],
    );
}

/// A quay that floats, of 40,000 t, and a ship of 20,000 t: the reduced mass is 13,333 t by hand.
#[test]
fn the_workbook_has_both_ships_of_a_ship_to_ship_berthing() {
    let place = Workplace::new("workbook_two_ships");
    let set = ["body.quay.fixed=false", "body.quay.mass=40000 t", "body.quay.gyradius=50 m"];
    let set: Vec<&str> = set.iter().flat_map(|set| ["--set", set]).collect();
    let run = place
        .run(&[&["run", "berth.toml", "--allow-failures", "--xlsx", "b.xlsx"], &set[..]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    let rows = cells(&mut book(&place, "b.xlsx"), "Berthing");
    let in_run = column(&rows, "Run, first hit");
    let value = |name: &str| {
        let row = rows.iter().find(|row| row[0] == name).unwrap_or_else(|| panic!("no {name}"));
        let Data::Float(value) = row[in_run] else { panic!("{name}: {row:?}") };
        value
    };
    assert_eq!(value("Displacement of the ship"), 20_000.0);
    assert_eq!(value("Displacement of the other ship"), 40_000.0);
    assert!((value("Reduced mass M of the two ships") - 40_000.0 / 3.0).abs() < 1e-6);
    let told = |start: &str| rows.iter().any(|row| row[0].to_string().starts_with(start));
    assert!(told("Cm ") && told("It differs from the Cm of the formula: "), "{rows:?}");
}

#[test]
fn a_run_in_which_nothing_is_found_has_a_line_that_says_so() {
    let place = Workplace::new("workbook_all_well");
    place.write("well.toml", include_bytes!("verdict/one_fender.toml"));
    let run = place.run(&["run", "well.toml", "--xlsx", "w.xlsx"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(place.json("out/well/summary.json")["verdict"]["key"], "all_well");
    let findings = cells(&mut book(&place, "w.xlsx"), "Findings");
    assert_eq!(findings[2][3], Data::String("Nothing was found: no limit was exceeded.".into()));
}

/// A run with vessels and tugs. The ship is broader for her draught than those that her estimate was held against.
#[test]
fn vessels_and_tugs_are_in_the_workbook() {
    let place = Workplace::new("workbook_tugs");
    let text = include_str!("../../../scenarios/berth/alongside_with_two_tugs.toml");
    place.write("tugs.toml", text.as_bytes());
    let run = place.run(&["run", "tugs.toml", "--xlsx", "t.xlsx", "--interval", "10 s"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let summary = place.json("out/tugs/summary.json");
    let mut book = book(&place, "t.xlsx");
    let vessels = cells(&mut book, "Vessels");
    let (speed, least) = ("Speed over ground", "Least clearance under the keel");
    let of = &summary["vessels"][0];
    let Data::Float(knots) = vessels[2][column(&vessels, speed)] else { panic!("a speed") };
    let theirs = of["peak_speed_over_ground_mps"].as_f64().expect("a speed");
    assert!((knots * 1852.0 / 3600.0 / theirs - 1.0).abs() < 1e-12, "{knots} {theirs}");
    let theirs = of["min_under_keel_clearance_m"].as_f64().expect("a clearance");
    assert_eq!(vessels[2][column(&vessels, least)], Data::Float(theirs));
    let tugs = cells(&mut book, "Tugs");
    for (row, of) in tugs[2..].iter().zip(summary["tugs"].as_array().expect("tugs")) {
        assert_eq!(row[0], of["name"].as_str().expect("a name"));
        let force_n = of["peak_force_n"].as_f64().expect("a force");
        assert_eq!(row[column(&tugs, "Peak force")], Data::Float(force_n / 1e3));
    }
    assert_eq!(tugs.len(), 4);
    assert_eq!(summary["verdict"]["key"], "extrapolated");
    let findings = cells(&mut book, "Findings");
    let Data::String(text) = &findings[2][3] else { panic!("{:?}", findings[2]) };
    assert!(text.starts_with("ship: beam over draught is 5.111"), "{text}");
}

#[test]
fn flexible_dolphins_are_in_the_workbook_and_on_the_title_page() {
    let place = Workplace::new("documents_dolphins");
    let text = include_str!("../../../scenarios/berth/flexible_dolphins.toml");
    place.write("dolphins.toml", text.as_bytes());
    let arguments = ["--xlsx", "d.xlsx", "--set", "berthing.abnormal_factor=1.5"];
    let run = place.run(&[&["run", "dolphins.toml", "--allow-failures"], &arguments[..]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    let summary = place.json("out/dolphins/summary.json");
    let dolphins = summary["dolphins"].as_array().expect("dolphins");
    let mut book = book(&place, "d.xlsx");
    let sheet = cells(&mut book, "Dolphins");
    assert_eq!(sheet.len(), 2 + dolphins.len());
    for (row, dolphin) in sheet[2..].iter().zip(dolphins) {
        assert_eq!(row[0], dolphin["name"].as_str().expect("a name"));
        let load_n = dolphin["peak_load_n"].as_f64().expect("a load");
        assert_eq!(row[column(&sheet, "Load")], Data::Float(load_n / 1e3));
    }
    let report = place.text("out/dolphins/report.html");
    contains_all(
        &report,
        &[
            "Largest load of a dolphin",
            "tanker meets bd_2, with her",
            "</strong> of rated energy of one<",
        ],
    );
    // Dolphin and fender have one name, and the wind makes her faster.
    assert!(!report.contains("bd_1 through bd_1"));
    contains_all(&report, &["m/s at the first touch: wind or other loads made the ship faster"]);
    contains_all(&run.stdout, &["m/s: wind or other loads made the ship faster"]);
}

#[test]
fn the_same_run_writes_the_same_workbook() {
    let place = Workplace::new("workbook_twice");
    for name in ["one.xlsx", "two.xlsx"] {
        place.run(&["report", "berth.toml", "--xlsx", name]);
    }
    assert!(place.read("one.xlsx") == place.read("two.xlsx"));
}

#[test]
fn the_title_page_has_what_file_and_command_line_give() {
    let place = Workplace::new("title_page");
    let text = format!(
        "{}\n[report]\nproject = \"Berth <4>\"\nclient = \"of the file\"\n",
        support::BERTH
    );
    place.write("titled.toml", text.as_bytes());
    let run = place.run(&[
        "report",
        "titled.toml",
        "--html",
        "page.html",
        "--client",
        "of \"the\" line",
        "--checked-by",
        "B. \\ Reviewer",
        "--number",
        "7\"</style>",
    ]);
    assert_eq!(run.code, 1, "a fender fails in it: {}", run.stderr);
    let page = place.text("page.html");
    contains_all(
        &page,
        &[
            "<dt>Project</dt><dd>Berth &lt;4&gt;</dd>",
            "<dt>Client</dt><dd>of &quot;the&quot; line</dd>",
            "<dt>Checked by</dt><dd>B. \\ Reviewer</dd>",
            "content: \"7\\22 \\3c /style\\3e  · A ship onto two fenders\"",
            "Governing numbers",
            "<h2>Assumptions</h2>",
            "<h2>Fender system</h2>",
        ],
    );
    assert!(!page.contains("of the file"), "the command line counts");
    assert!(!place.exists("out"), "no tables");
    let unknown = place.run(&["report", "titled.toml", "--set", "report.cleint=x"]);
    assert_eq!(unknown.code, 2);
    contains_all(&unknown.stderr, &["cleint", "client"]);
}

#[test]
fn sheets_that_cannot_be_are_bad_input() {
    let place = Workplace::new("bad_sheets");
    for (sheets, words) in [
        ("fender", ["there is no table `fender`", "bodies, contacts, fenders"]),
        ("lines", ["the scenario has no lines", "--sheets lines"]),
    ] {
        let run = place.run(&["report", "berth.toml", "--xlsx", "x.xlsx", "--sheets", sheets]);
        assert_eq!(run.code, 2);
        contains_all(&run.stderr, &words);
        assert!(!place.exists("x.xlsx"));
    }
    assert_eq!(place.run(&["report", "berth.toml", "--sheets", "fenders"]).code, 2);
}

/// A program in the place of a browser: it notes its arguments and prints a page, or fails.
#[cfg(unix)]
fn browser(place: &Workplace, prints: &str) {
    let script = format!(
        "#!/bin/sh\nprintf '%s\\n' \"$@\" > arguments\nfor a; do case $a in --print-to-pdf=*) pdf=${{a#*=}};; esac; done\n{prints}\n"
    );
    place.write("browser", script.as_bytes());
    assert_eq!(place.shell("chmod +x browser").code, 0);
}

#[cfg(unix)]
/// The report of a campaign is printed when its runs are made, and again from its table; a share has none.
#[test]
fn a_browser_prints_the_report_of_a_campaign() {
    let place = Workplace::new("pdf_campaign");
    browser(&place, "printf '%%PDF-1.4 printed' > \"$pdf\"");
    place.write(
        "study.toml",
        b"scenario = \"berth.toml\"\nset = [\"time.duration=5 s\"]\n[variable.speed]\nkey = \"body.ship.velocity.sway\"\nvalues = [0.01, 0.02]\n",
    );
    let run =
        place.shell("FENDERLINE_BROWSER=./browser $FENDERLINE campaign study.toml --pdf x.pdf");
    assert!(run.code <= 1, "{}", run.stderr);
    contains_all(&run.stdout, &["PDF: x.pdf"]);
    assert_eq!(place.text("x.pdf"), "%PDF-1.4 printed");
    let again = "FENDERLINE_BROWSER=./browser $FENDERLINE campaign report study.toml --pdf y.pdf";
    assert_eq!(place.shell(again).code, 0);
    assert_eq!(place.text("y.pdf"), "%PDF-1.4 printed");
    let share = place.run(&["campaign", "study.toml", "--shard", "1/2", "--pdf", "z.pdf"]);
    assert_eq!(share.code, 2);
    contains_all(&share.stderr, &["--pdf goes with the whole report"]);
}

#[test]
fn a_browser_prints_the_pdf() {
    let place = Workplace::new("pdf");
    browser(&place, "printf '%%PDF-1.4 printed' > \"$pdf\"");
    let line = "FENDERLINE_BROWSER=./browser $FENDERLINE report berth.toml --pdf 'a b.pdf' --allow-failures";
    let run = place.shell(line);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(place.text("a b.pdf"), "%PDF-1.4 printed");
    let arguments = place.text("arguments");
    contains_all(&arguments, &["--headless", "--no-pdf-header-footer", "/a%20b.pdf.print-"]);
    let left = place.files(".");
    assert!(left.iter().all(|name| !name.contains("print-")), "{left:?}");
    assert!(!left.contains(&"berth.html".to_owned()), "only what was asked for");
}

#[cfg(unix)]
#[test]
fn a_browser_that_fails_is_reported_and_leaves_nothing() {
    let place = Workplace::new("pdf_fails");
    browser(&place, "echo 'no display' >&2; exit 3");
    let line =
        "FENDERLINE_BROWSER=./browser $FENDERLINE run berth.toml --pdf x.pdf --allow-failures";
    let run = place.shell(line);
    assert_eq!(run.code, 1);
    contains_all(&run.stderr, &["cannot make x.pdf", "printed nothing", "no display"]);
    assert!(!place.exists("x.pdf"));
    assert!(place.exists("out/berth/summary.json"), "the results are complete");
}

#[cfg(unix)]
#[test]
fn without_a_browser_nothing_runs() {
    let place = Workplace::new("pdf_none");
    let missing = place.shell("PATH=/nowhere $FENDERLINE run berth.toml --pdf x.pdf");
    assert_eq!(missing.code, 2);
    contains_all(
        &missing.stderr,
        &[
            "no browser",
            "chromium",
            "google-chrome",
            "msedge",
            "apt-get install",
            "FENDERLINE_BROWSER",
        ],
    );
    let named = place.shell("FENDERLINE_BROWSER=/nowhere/x $FENDERLINE run berth.toml --pdf x.pdf");
    assert_eq!(named.code, 2);
    contains_all(&named.stderr, &["FENDERLINE_BROWSER names /nowhere/x"]);
    assert!(!place.exists("out"));
}

/// `cargo xtask pages` runs it.
#[test]
#[ignore = "needs Chromium"]
fn chromium_prints_the_report_on_numbered_pages() {
    let place = Workplace::new("pdf_chromium");
    let run = place.run(&["report", "berth.toml", "--pdf", "x.pdf", "--allow-failures"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let pdf = place.read("x.pdf");
    assert!(pdf.starts_with(b"%PDF-") && pdf.len() > 50_000, "{} bytes", pdf.len());
    let pages = pdf.windows(12).filter(|part| part.starts_with(b"/Type /Page\n")).count();
    assert!((5..20).contains(&pages), "{pages} pages");
}

/// LibreOffice writes numbers with 15 digits: the cells equal those of the csv files to a unit of the last. Run by hand after a
/// change of the workbook (Debian: libreoffice-calc-nogui): `cargo test -p fenderline --test all -- --ignored libreoffice`.
#[test]
#[ignore = "needs LibreOffice Calc"]
fn libreoffice_reads_the_cells_of_the_csv_files() {
    const TABLES: [&str; 4] = ["fenders", "contacts", "bodies", "energy"];
    let place = Workplace::new("workbook_libreoffice");
    let sheets = TABLES.join(",");
    let run = place.run(&[
        "run",
        "berth.toml",
        "--allow-failures",
        "--xlsx",
        "b.xlsx",
        "--sheets",
        &sheets,
    ]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    // Token 8, false: values, not what is shown of them. Token 12, -1: all sheets.
    let filter = "csv:Text - txt - csv (StarCalc):44,34,76,1,,0,false,false,false,false,false,-1";
    let line = format!(
        "soffice -env:UserInstallation=file://$PWD/profile --headless --convert-to '{filter}' b.xlsx"
    );
    let run = place.shell(&line);
    assert_eq!(run.code, 0, "{}{}", run.stdout, run.stderr);
    for table in TABLES {
        let theirs = place.text(&format!("b-{table} by time.csv"));
        let ours = place.text(&format!("out/berth/{table}.csv"));
        let (mut theirs, mut ours) = (theirs.lines(), ours.lines());
        assert_eq!(theirs.next(), ours.next());
        // The units.
        theirs.next();
        let (theirs, ours): (Vec<&str>, Vec<&str>) = (theirs.collect(), ours.collect());
        assert_eq!(theirs.len(), ours.len());
        assert!(ours.len() > 50, "{table}");
        for (their, our) in theirs.into_iter().zip(ours) {
            assert_eq!(their.split(',').count(), our.split(',').count());
            for (their, our) in their.split(',').zip(our.split(',')) {
                let their = their.trim_matches('"');
                match (their.parse::<f64>(), our.parse::<f64>()) {
                    (Ok(a), Ok(b)) => {
                        // A unit of the 15th digit: LibreOffice rounds some to the other side. And no more than 20 decimals.
                        assert!((a - b).abs() <= 1e-14 * b.abs() + 5e-21, "{table}: {a} for {b}");
                    }
                    _ => assert_eq!(their.to_lowercase(), our.to_lowercase(), "{table}"),
                }
            }
        }
    }
}
