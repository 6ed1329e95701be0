//! `fenderline validate`: the table, the files, the exit codes.

use crate::support;

use support::Workplace;

#[test]
fn every_published_number_is_within_its_tolerance_or_a_known_mismatch() {
    let place = Workplace::new("validate_table");
    let run = place.run(&["validate"]);
    assert_eq!(run.code, 0, "{}{}", run.stdout, run.stderr);
    assert_eq!(run.stderr, "");
    // "146 of 152 rows within tolerance; 6 known not to match": every one is accounted for.
    let last = run.stdout.lines().last().unwrap_or_default();
    assert!(last.ends_with("known not to match"), "{last}");
    let counts: Vec<usize> = last.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    assert!(counts.len() == 3 && counts[0] + counts[2] == counts[1] && counts[1] > 140, "{last}");
    for subject in [
        "CONTACT: THE PAPER'S EXPERIMENTS",
        "KVLCC2: TURNING AND ZIG-ZAG",
        "KCS: TURNING AND ZIG-ZAG",
        "HULL AT LOW SPEED",
        "ESSO OSAKA: TURNING AT LOW SPEED",
        "ADDED MASS",
        "SHIPS FROM MAIN PARTICULARS",
        "SHALLOW WATER",
        "PROPELLERS AND THRUSTERS",
        "WIND",
        "CURRENT AND WAVES",
        "LINES AND TUGS",
        "HEAVE AND ROLL",
    ] {
        assert_eq!(run.stdout.lines().filter(|line| *line == subject).count(), 1, "{subject}");
    }
    for standing in ["[published]", "[computed]", "[recalled]", "[closed form]"] {
        assert!(run.stdout.contains(standing), "{standing}");
    }
    for row in ["Greatest depth at 0.5 kn", "Impulse, Δt 2 s", "Final speed γV⁰ at 4 kn, Δt 2 s"]
    {
        assert!(
            run.stdout.lines().any(|line| line.starts_with(row) && line.ends_with("yes")),
            "{row}"
        );
    }
    // What does not match is shown, with its reason.
    assert!(
        run.stdout.lines().any(|l| l.starts_with("First peak lasts 1 to 2 s") && l.ends_with("NO"))
    );
    let row = "Force astern at Js −0.2";
    assert!(run.stdout.lines().any(|line| line.starts_with(row) && line.ends_with("NO")));
    assert!(run.stdout.contains(&format!("NOT MATCHING, known: {row}")));
    assert!(!run.stdout.contains("NOT MATCHING:"), "none that is not known");
    assert!(run.stdout.contains("6 of 7 statements of the sources hold"));
    assert!(
        run.stdout
            .contains("every tolerance is below twice the uncertainty of its reference: at most ")
    );
    let widest = run.stdout.lines().map(|line| line.chars().count()).max().unwrap_or(0);
    assert!(widest <= 120, "a line of {widest} characters");
}

#[test]
fn the_report_is_complete_and_the_same_each_time() {
    let place = Workplace::new("validate_files");
    for folder in ["one", "two"] {
        let run = place.run(&["validate", "--out", folder]);
        assert_eq!(run.code, 0, "{}", run.stderr);
    }
    for name in ["validation.html", "validation.csv", "validation.json"] {
        let [one, two] = ["one", "two"].map(|folder| {
            std::fs::read_to_string(place.path(&format!("{folder}/{name}")))
                .expect("the file is there")
        });
        assert!(one == two, "{name} differs between two runs");
        assert!(!place.exists(&format!("one/{name}.part")));
    }
    let page = std::fs::read_to_string(place.path("one/validation.html")).expect("the page");
    for figure in
        ["Fig. 8", "Fig. 9", "Fig. 10", "Fig. 11", "Fig. 12", "298 m × 46 m", "32 m × 13 m"]
    {
        assert!(page.contains(figure), "{figure} is missing");
    }
    let before_script = page.split("<script>").next().unwrap_or_default();
    for unwanted in ["NaN", "http://", "https://", "src="] {
        assert!(!before_script.contains(unwanted), "the page contains {unwanted}");
    }

    let mut table = csv::Reader::from_path(place.path("one/validation.csv")).expect("the table");
    let head = table.headers().expect("a header").clone();
    let column = |name: &str| head.iter().position(|h| h == name).expect(name);
    let depths: Vec<(f64, f64)> = table
        .records()
        .map(|record| record.expect("a row"))
        .filter(|record| &record[column("place")] == "Table 2")
        .map(|r| {
            [column("published"), column("ours")].map(|i| r[i].parse::<f64>().expect("a number"))
        })
        .map(|[published, ours]| (published, ours))
        .collect();
    assert_eq!(depths.len(), 4);
    for (published, ours) in depths {
        assert!((ours / published - 1.0).abs() <= 0.1, "{ours} m against {published} m");
    }

    let text = std::fs::read_to_string(place.path("one/validation.json")).expect("the JSON");
    let document: serde_json::Value = serde_json::from_str(&text).expect("it parses");
    let numbers = document["numbers"].as_array().expect("a list");
    assert!(numbers.len() >= 230, "{} rows", numbers.len());
    for number in numbers {
        let case = &number["case"];
        let [tolerance, uncertainty] = ["tolerance", "uncertainty"]
            .map(|key| number[key].as_f64().unwrap_or_else(|| panic!("{case}: {key}")));
        assert!(tolerance < 2.0 * uncertainty, "{case}: {tolerance} of {uncertainty}");
        let from = number["uncertainty_from"].as_str().unwrap_or_default();
        assert!(from.len() > 20, "{case}: it is said where the uncertainty comes from");
    }
}

#[test]
fn a_folder_that_cannot_be_created_is_an_error() {
    let place = Workplace::new("validate_no_folder");
    let run = place.run(&["validate", "--out", "tug.toml"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("cannot write tug.toml"), "{}", run.stderr);
    assert!(run.stdout.contains("rows within tolerance"), "the table is printed all the same");
}
