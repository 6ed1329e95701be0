/*
 * A ship comes alongside two fenders of the catalogue, in a loop as a game has it: the example of examples/cpp in C#. It prints the
 * same lines.
 */
using System;
using System.Globalization;
using System.IO;
using Fenderline;

internal static class GameLoop
{
    /// <summary>The starboard side of a ship of 120 m from her mesh, from bow to stern.</summary>
    private static Point[] StarboardSide()
    {
        var side = new Point[62];
        for (int i = 0; i <= 60; i++)
        {
            double share = i / 60.0;
            side[i] = new Point(60.0 - 30.0 * share, 10.0 * Math.Sin(1.5707963267948966 * share));
        }
        side[61] = new Point(-60.0, 10.0);
        return side;
    }

    private sealed class Game : IDisposable
    {
        public readonly Engine Engine;
        public readonly State[] States;
        private readonly Wrench[] wrenches;
        private readonly double[] mass;
        private readonly int ship;
        private uint random = 1;

        public Game()
        {
            Point[] wall = { new Point(-60, -5), new Point(60, -5), new Point(60, 0), new Point(-60, 0) };
            Point[] hull = Outlines.Simplified(Outlines.Mirrored(StarboardSide(), 0.01), 0.05);
            var rubber = new MaterialParts
            {
                StiffnessNpm2 = 5e6, ShearStiffnessNpm = 3e6, FrictionStatic = 0.2, FrictionDynamic = 0.2,
            };
            var floating = new BodyParts
            {
                MassKg = 12e6, YawInertiaKgm2 = 1.1e10, AddedSurgeKg = 0.6e6, AddedSwayKg = 6e6, AddedYawKgm2 = 5e9,
                EastM = 10.0 + 1.05 + 0.2, // half her beam, the fender, a gap
            };
            using (var builder = new Builder())
            {
                Material facing = builder.AddMaterial("facing", rubber);
                Body quay = builder.AddBody("quay", new BodyParts(), wall);
                Body body = builder.AddBody("ship", floating, hull);
                builder.AddPair(quay, body, facing);
                foreach (double forwardM in new[] { -20.0, 20.0 })
                {
                    builder.AddFender(forwardM < 0 ? "aft" : "fore", new CatalogueFender
                    {
                        On = "quay", Material = "facing", Type = "cone", Size = "1050 F1.1",
                        PositionM = new Point(forwardM, 0.0), WidthM = 2.0, TemperatureC = 30.0,
                    });
                }
                // The game moves the ship, and its frames vary.
                var game = new Settings { Host = Host.CoSimulation, Integration = Integration.SemiImplicit };
                Engine = builder.Build(game);
                mass = Engine.MassMatrix(body);
                ship = (int)body.Number;
            }
            States = Engine.InitialStates();
            wrenches = new Wrench[States.Length];
            States[ship].EastMps = -0.12;
            Engine.Record(200);
        }

        public void Dispose() { Engine.Dispose(); }

        public State Ship { get { return States[ship]; } }

        public double EnergyJ { get { return 0.5 * mass[4] * Ship.EastMps * Ship.EastMps; } }

        /// <summary>One frame. A paused game passes 0 s.</summary>
        public void Frame(double frameS)
        {
            Engine.Advance(States, null, frameS, wrenches);
            // Her own forces would be added here. She keeps her heading, so that surge is north and sway is east.
            States[ship].NorthMps += wrenches[ship].NorthN / mass[0] * frameS;
            States[ship].EastMps += wrenches[ship].EastN / mass[4] * frameS;
            States[ship].YawRateRadps += wrenches[ship].MomentNm / mass[8] * frameS;
            States[ship].NorthM += Ship.NorthMps * frameS;
            States[ship].EastM += Ship.EastMps * frameS;
            States[ship].HeadingRad += Ship.YawRateRadps * frameS;
        }

        /// <summary>Between 8 and 40 ms.</summary>
        public double NextFrameS()
        {
            random = unchecked(1664525u * random + 1013904223u);
            return 0.008 + 0.032 * (random / 4294967296.0);
        }

        public Tuple<byte[], State, uint> Save() { return Tuple.Create(Engine.Save(), Ship, random); }

        public void Load(Tuple<byte[], State, uint> from)
        {
            Engine.Restore(from.Item1);
            States[ship] = from.Item2;
            random = from.Item3;
        }
    }

    private static void Say(string form, params object[] values)
    {
        Console.WriteLine(string.Format(CultureInfo.InvariantCulture, form, values));
    }

    private static bool SameBytes(byte[] one, byte[] other)
    {
        return Convert.ToBase64String(one) == Convert.ToBase64String(other);
    }

    private static int Main(string[] arguments)
    {
        Contact[] contacts = null;
        Event[] events = null;
        Tuple<byte[], State, uint> saved = null;
        double absorbedJ = 0.0, deflectionM = 0.0, gaugeN = 0.0, tS = 0.0;
        using (var own = new Game())
        using (var other = new Game())
        {
            double energyJ = own.EnergyJ;
            var views = new FenderView[own.Engine.FenderCount];
            for (int frame = 0; tS < 20.0; frame++)
            {
                double frameS = frame % 100 == 50 ? 0.0 : own.NextFrameS();
                own.Frame(frameS);
                tS += frameS;
                double nowJ = 0.0;
                int count = own.Engine.GetContacts(ref contacts);
                for (int i = 0; i < count; i++) nowJ += contacts[i].PeakAbsorbedJ;
                absorbedJ = Math.Max(absorbedJ, nowJ);
                own.Engine.GetFenderViews(views);
                foreach (FenderView fender in views)
                {
                    // Draw the face from Face1M to Face2M, as a child of the quay.
                    deflectionM = Math.Max(deflectionM, fender.DeflectionM);
                    gaugeN = Math.Max(gaugeN, fender.NormalForceN);
                }
                count = own.Engine.GetEvents(ref events);
                for (int i = 0; i < count; i++)
                    if (events[i].Kind == EventKind.ContactBegan)
                        Say("{0:F1} s: contact", tS);
                if (frame == 150) saved = own.Save();
            }
            Say("largest deflection {0:F3} m, {1:F0} kN on the gauge", deflectionM, gaugeN / 1e3);
            Say("the fenders took {0:F1} % of her energy, she leaves at {1:F3} m/s", 100.0 * absorbedJ / energyJ,
                own.Ship.EastMps);

            own.Load(saved);
            other.Load(saved);
            for (int frame = 0; frame < 100; frame++)
            {
                own.Frame(own.NextFrameS());
                other.Frame(other.NextFrameS());
            }
            bool same = own.Ship.EastM == other.Ship.EastM && SameBytes(own.Engine.Save(), other.Engine.Save());
            byte[] dump = own.Engine.Dump();
            int steps, different = Engine.Replay(dump, out steps);
            Say("saved game: {0}; dump: {1} steps, {2} different", same ? "the same bits" : "OTHER BITS", steps, different);
            if (arguments.Length > 0) File.WriteAllBytes(arguments[0], dump);

            bool refused = false;
            try
            {
                own.Engine.FindBody("pier");
            }
            catch (FenderlineException error)
            {
                refused = error.Status == Status.NoSuch && error.Message.Contains("`pier`");
            }
            // No force but contact acted: the fenders took what she had.
            bool right = Math.Abs(absorbedJ / energyJ - 1.0) < 0.01 && same && different == 0 && refused;
            return right ? 0 : 1;
        }
    }
}
