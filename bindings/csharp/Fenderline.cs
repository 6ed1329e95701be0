/*
 * fenderline for C#: the C interface of fenderline.h by P/Invoke, for .NET Standard 2.0 and later: .NET, .NET Framework, Mono,
 * Unity (also IL2CPP). One file: add it to your project, and put the library where the runtime finds it: fenderline.dll,
 * libfenderline.so. docs/guides/game_loop.md shows how to use it, also in Unity.
 *
 * - A call that fails throws FenderlineException and changes nothing.
 * - Engine and Builder are IDisposable; what is forgotten is freed by the garbage collector.
 * - Body, Fender and Material are types of their own: a body's index does not pass for a fender's.
 * - Structures have the members, units and frame of fenderline.h. The constructors of this file set their sizes.
 * - Calls of each frame (Advance, GetContacts, GetFenderViews) allocate nothing once their arrays are large enough.
 */

using System;
using System.Globalization;
using System.Runtime.InteropServices;
using System.Text;

namespace Fenderline
{
    /// <summary>Result of a call of the C interface.</summary>
    public enum Status
    {
        Ok = 0,
        BadPointer = 1,
        BadHandle = 2,
        BadSize = 3,
        BadText = 4,
        BadArgument = 5,
        BadScenario = 6,
        BadModel = 7,
        BadNumber = 8,
        NoSuch = 9,
        OutOfOrder = 10,
        NotAvailable = 11,
        BadBytes = 12,
        OtherModel = 13,
        BufferTooSmall = 14,
        Panicked = 15,
    }

    /// <summary>A call that the library refused.</summary>
    public sealed class FenderlineException : Exception
    {
        /// <summary>Why.</summary>
        public Status Status { get; }

        internal FenderlineException(Status status, string message) : base(status + ": " + message)
        {
            Status = status;
        }
    }

    /// <summary>Contact method.</summary>
    public enum Method : uint { Default = 0, Coupled = 1, Paper = 2 }

    /// <summary>Kind of host: see FL_HOST_ in fenderline.h.</summary>
    public enum Host : uint { Direct = 0, CoSimulation = 1 }

    /// <summary>Where the Coriolis terms of added mass are.</summary>
    public enum Coriolis : uint { Default = 0, ByEngine = 1, InLoads = 2 }

    /// <summary>How a co-simulation host integrates.</summary>
    public enum Integration : uint { ForwardEuler = 0, SemiImplicit = 1 }

    /// <summary>Kind of an event: see FL_EVENT_ in fenderline.h.</summary>
    public enum EventKind : uint
    {
        ContactBegan = 0,
        ContactEnded = 1,
        PatchSplit = 2,
        PatchesMerged = 3,
        Contained = 4,
        DeepOverlap = 5,
        Teleported = 6,
        FenderRatingExceeded = 7,
        FenderFailed = 8,
        NotConverged = 9,
        PlacedInOverlap = 10,
        MassMismatch = 11,
    }

    /// <summary>Index of a body.</summary>
    public struct Body : IEquatable<Body>
    {
        public readonly uint Number;
        public Body(uint number) { Number = number; }
        public bool Equals(Body other) { return Number == other.Number; }
        public override bool Equals(object other) { return other is Body && Equals((Body)other); }
        public override int GetHashCode() { return (int)Number; }
    }

    /// <summary>Index of a fender.</summary>
    public struct Fender : IEquatable<Fender>
    {
        /// <summary>No fender: outline meets outline.</summary>
        public static readonly Fender None = new Fender(uint.MaxValue);
        public readonly uint Number;
        public Fender(uint number) { Number = number; }
        public bool Equals(Fender other) { return Number == other.Number; }
        public override bool Equals(object other) { return other is Fender && Equals((Fender)other); }
        public override int GetHashCode() { return (int)Number; }
    }

    /// <summary>Index of a material.</summary>
    public struct Material
    {
        public readonly uint Number;
        public Material(uint number) { Number = number; }
    }

    /// <summary>A pair of numbers (m): forward and starboard of a body's centre of gravity, or north and east.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Point
    {
        public double X, Y;
        public Point(double x, double y) { X = x; Y = y; }
    }

    /// <summary>fl_state: a body's centre of gravity, earth-fixed.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct State
    {
        public double NorthM, EastM, HeadingRad, NorthMps, EastMps, YawRateRadps;
    }

    /// <summary>fl_wrench: a force at the centre of gravity and a moment about it, earth-fixed.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Wrench
    {
        public double NorthN, EastN, MomentNm;
    }

    /// <summary>fl_settings.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Settings
    {
        internal UIntPtr Size;
        public Method Method;
        public Host Host;
        public Coriolis Coriolis;
        public Integration Integration;
        public uint DelaySteps;
    }

    /// <summary>fl_material.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct MaterialParts
    {
        internal UIntPtr Size;
        public double StiffnessNpm2, DampingNspm2, ShearStiffnessNpm, FrictionStatic, FrictionDynamic, Restitution;
    }

    /// <summary>fl_body. All masses 0: a fixed body.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct BodyParts
    {
        internal UIntPtr Size;
        public double MassKg, YawInertiaKgm2, AddedSurgeKg, AddedSwayKg, AddedYawKgm2, NorthM, EastM, HeadingRad;
    }

    /// <summary>fl_fender; body and material are arguments of Builder.AddFender.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct FenderParts
    {
        internal UIntPtr Size;
        public double ForwardM, StarboardM, FacingRad, WidthM, ProjectionM, RatedDeflectionM, StopFromM,
            StopStiffnessNpm;
        internal uint Body, Material;
        public double ReturnedEnergy;
    }

    /// <summary>fl_contact: one contact patch in the last step.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Contact
    {
        internal UIntPtr Size;
        public Body Body1, Body2;
        public Fender Fender;
        public uint Patch, Flags, Reserved;
        public double AreaM2, DepthM, NorthM, EastM, NormalNorth, NormalEast, VNormalMps, VTangentialMps, ShearM,
            NormalForceN, TangentialForceN, PeakNormalForceN, PeakDepthM, SpringN, StopN, DamperN, LimiterN, StoredJ,
            PeakAbsorbedJ, TiltRad, Factor, HysteresisJ;

        public bool Slips { get { return (Flags & 1) != 0; } }
        public bool IsLimited { get { return (Flags & 2) != 0; } }
    }

    /// <summary>fl_event.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Event
    {
        internal UIntPtr Size;
        public EventKind Kind;
        public Body Body1, Body2;
        public Fender Fender;
    }

    /// <summary>fl_fender_view: a fender as it is drawn, in the frame of the body that carries it.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct FenderView
    {
        public Body Body;
        /// <summary>The body that presses it; meaningless unless IsPressed.</summary>
        public Body Hull;
        public Point Mount1M, Mount2M, Face1M, Face2M;
        public double DeflectionM, RatedDeflectionM, NormalForceN, PeakNormalForceN, PeakDeflectionM, PanelTurnRad;

        public bool IsPressed { get { return Hull.Number != uint.MaxValue; } }
    }

    /// <summary>A fender of the catalogue, or of any kind that a scenario file can describe.</summary>
    public sealed class CatalogueFender
    {
        /// <summary>Name of the body that carries it, and of its material.</summary>
        public string On, Material;
        /// <summary>Family and designation, such as "cone" and "1050 F1.1".</summary>
        public string Type, Size;
        /// <summary>Middle of its mounting line, in the frame of its body (m).</summary>
        public Point PositionM;
        /// <summary>Width of its face (m).</summary>
        public double WidthM;
        /// <summary>Direction of its outward normal (rad); null: out of the edge on which it stands.</summary>
        public double? FacingRad;
        /// <summary>Temperature of the rubber (degrees Celsius); null: no factor.</summary>
        public double? TemperatureC;
        /// <summary>Further keys of a scenario's [fender.NAME], one KEY=VALUE per line.</summary>
        public string More = "";

        internal string Keys()
        {
            var keys = new StringBuilder();
            keys.Append("on=").Append(On).Append("\nmaterial=").Append(Material).Append("\ntype=").Append(Type);
            if (!string.IsNullOrEmpty(Size)) keys.Append("\nsize=").Append(Size);
            keys.Append("\nposition=[").Append(Text(PositionM.X)).Append(", ").Append(Text(PositionM.Y)).Append("]");
            keys.Append("\nwidth=").Append(Text(WidthM));
            if (FacingRad.HasValue) keys.Append("\nfacing=").Append(Text(FacingRad.Value));
            if (TemperatureC.HasValue) keys.Append("\ntemperature=").Append(Text(TemperatureC.Value)).Append(" degC");
            return keys.Append("\n").Append(More).ToString();
        }

        private static string Text(double number)
        {
            return number.ToString("R", CultureInfo.InvariantCulture);
        }
    }

    /// <summary>Parts from which engines are made.</summary>
    public sealed class Builder : IDisposable
    {
        private readonly BuilderHandle handle;

        public Builder()
        {
            Native.CheckVersion();
            Native.Must(Native.fl_builder_new(out handle));
        }

        public void Dispose() { handle.Dispose(); }

        public Material AddMaterial(string name, MaterialParts parts)
        {
            uint number;
            var text = Native.Utf8(name);
            parts.Size = Native.SizeOf<MaterialParts>();
            Native.Must(Native.fl_builder_add_material(handle, text, Native.Length(text), ref parts, out number));
            return new Material(number);
        }

        public Body AddBody(string name, BodyParts parts, Point[] outlineM)
        {
            uint number;
            var text = Native.Utf8(name);
            parts.Size = Native.SizeOf<BodyParts>();
            Native.Must(Native.fl_builder_add_body(handle, text, Native.Length(text), ref parts, outlineM,
                Native.Length(outlineM), out number));
            return new Body(number);
        }

        /// <summary>A fender with a curve of its own: X deflection (m), Y reaction (N).</summary>
        public Fender AddFender(string name, Body on, Material material, FenderParts parts, Point[] curve)
        {
            uint number;
            var text = Native.Utf8(name);
            parts.Size = Native.SizeOf<FenderParts>();
            parts.Body = on.Number;
            parts.Material = material.Number;
            Native.Must(Native.fl_builder_add_fender(handle, text, Native.Length(text), ref parts, curve,
                Native.Length(curve), out number));
            return new Fender(number);
        }

        public Fender AddFender(string name, CatalogueFender parts) { return AddFender(name, parts.Keys()); }

        /// <summary>A fender by the keys of a scenario's [fender.NAME], one KEY=VALUE per line.</summary>
        public Fender AddFender(string name, string keys)
        {
            uint number;
            byte[] text = Native.Utf8(name), own = Native.Utf8(keys);
            Native.Must(Native.fl_builder_add_fender_by_keys(handle, text, Native.Length(text), own,
                Native.Length(own), out number));
            return new Fender(number);
        }

        public void AddPair(Body one, Body other, Material material)
        {
            Native.Must(Native.fl_builder_add_pair(handle, one.Number, other.Number, material.Number));
        }

        public void AddAllOtherPairs(Material material)
        {
            Native.Must(Native.fl_builder_add_all_other_pairs(handle, material.Number));
        }

        public Engine Build() { return Build(new Settings()); }

        public Engine Build(Settings settings)
        {
            EngineHandle made;
            settings.Size = Native.SizeOf<Settings>();
            Native.Must(Native.fl_builder_build(handle, ref settings, out made));
            return new Engine(made);
        }
    }

    /// <summary>A contact engine.</summary>
    public sealed class Engine : IDisposable
    {
        private readonly EngineHandle handle;

        internal Engine(EngineHandle handle) { this.handle = handle; }

        public static Engine FromFile(string path) { return FromFile(path, "", new Settings()); }

        /// <summary>From a scenario file; overrides replace keys, one KEY=VALUE per line.</summary>
        public static Engine FromFile(string path, string overrides, Settings settings)
        {
            EngineHandle made;
            byte[] text = Native.Utf8(path), own = Native.Utf8(overrides);
            Native.CheckVersion();
            settings.Size = Native.SizeOf<Settings>();
            Native.Must(Native.fl_engine_from_file(text, Native.Length(text), own, Native.Length(own), ref settings,
                out made));
            return new Engine(made);
        }

        /// <summary>From the text of a scenario.</summary>
        public static Engine FromText(string scenario, string overrides, Settings settings)
        {
            EngineHandle made;
            byte[] text = Native.Utf8(scenario), own = Native.Utf8(overrides);
            Native.CheckVersion();
            settings.Size = Native.SizeOf<Settings>();
            Native.Must(Native.fl_engine_from_text(text, Native.Length(text), own, Native.Length(own), ref settings,
                out made));
            return new Engine(made);
        }

        public void Dispose() { handle.Dispose(); }

        public int BodyCount
        {
            get
            {
                UIntPtr count;
                Native.Must(Native.fl_engine_body_count(handle, out count));
                return (int)count;
            }
        }

        public int FenderCount
        {
            get
            {
                UIntPtr count;
                Native.Must(Native.fl_engine_fender_count(handle, out count));
                return (int)count;
            }
        }

        public Body FindBody(string name)
        {
            uint number;
            var text = Native.Utf8(name);
            Native.Must(Native.fl_engine_find_body(handle, text, Native.Length(text), out number));
            return new Body(number);
        }

        public Fender FindFender(string name)
        {
            uint number;
            var text = Native.Utf8(name);
            Native.Must(Native.fl_engine_find_fender(handle, text, Native.Length(text), out number));
            return new Fender(number);
        }

        /// <summary>Notices of the scenario, and what of it is left to the host; one per line.</summary>
        public string Notices()
        {
            UIntPtr length;
            Native.Must(Native.fl_engine_notices(handle, null, UIntPtr.Zero, out length));
            var text = new byte[(int)length + 1];
            Native.Must(Native.fl_engine_notices(handle, text, Native.Length(text), out length));
            return Encoding.UTF8.GetString(text, 0, (int)length);
        }

        /// <summary>Mass matrix over surge, sway and yaw, row by row.</summary>
        public double[] MassMatrix(Body body)
        {
            var matrix = new double[9];
            Native.Must(Native.fl_engine_mass_matrix(handle, body.Number, matrix));
            return matrix;
        }

        public State[] InitialStates()
        {
            var states = new State[BodyCount];
            Native.Must(Native.fl_engine_initial_states(handle, states, Native.Length(states)));
            return states;
        }

        /// <summary>The outline of a body in its own frame; constant.</summary>
        public Point[] Outline(Body body)
        {
            UIntPtr count;
            Native.Must(Native.fl_engine_outline(handle, body.Number, null, UIntPtr.Zero, out count));
            var outline = new Point[(int)count];
            Native.Must(Native.fl_engine_outline(handle, body.Number, outline, count, out count));
            return outline;
        }

        public void SetState(Body body, State state)
        {
            Native.Must(Native.fl_engine_set_state(handle, body.Number, ref state));
        }

        /// <summary>Sets the loads; null unsets them.</summary>
        public void SetLoads(Wrench[] loads)
        {
            Native.Must(Native.fl_engine_set_loads(handle, loads, Native.Length(loads)));
        }

        public void MarkTeleported(Body body) { Native.Must(Native.fl_engine_mark_teleported(handle, body.Number)); }

        /// <summary>Sets states, and loads unless they are null, takes a step and returns the wrenches in the caller's array.</summary>
        public void Advance(State[] states, Wrench[] loads, double stepS, Wrench[] wrenches)
        {
            if (states == null || wrenches == null || wrenches.Length != states.Length
                || (loads != null && loads.Length != states.Length))
                throw new ArgumentException("Advance takes arrays of one length");
            Native.Must(Native.fl_engine_advance(handle, states, loads, Native.Length(states), stepS, wrenches));
        }

        public void PeakWrenches(Wrench[] into)
        {
            Native.Must(Native.fl_engine_peak_wrenches(handle, into, Native.Length(into)));
        }

        public void StatesAfter(State[] into)
        {
            Native.Must(Native.fl_engine_states_after(handle, into, Native.Length(into)));
        }

        /// <summary>All contacts of the last step, in an array that grows where it is too small; returns their number.</summary>
        public int GetContacts(ref Contact[] into)
        {
            UIntPtr count, size = Native.SizeOf<Contact>();
            if (into == null) into = new Contact[8];
            var status = Native.fl_engine_contacts(handle, into, size, Native.Length(into), out count);
            if (status == Status.BufferTooSmall)
            {
                into = new Contact[2 * (int)count];
                status = Native.fl_engine_contacts(handle, into, size, Native.Length(into), out count);
            }
            Native.Must(status);
            return (int)count;
        }

        /// <summary>All events of the last step, as GetContacts.</summary>
        public int GetEvents(ref Event[] into)
        {
            UIntPtr count, size = Native.SizeOf<Event>();
            if (into == null) into = new Event[8];
            var status = Native.fl_engine_events(handle, into, size, Native.Length(into), out count);
            if (status == Status.BufferTooSmall)
            {
                into = new Event[2 * (int)count];
                status = Native.fl_engine_events(handle, into, size, Native.Length(into), out count);
            }
            Native.Must(status);
            return (int)count;
        }

        /// <summary>All fenders as they are drawn, in an array of FenderCount elements.</summary>
        public void GetFenderViews(FenderView[] into)
        {
            Native.Must(Native.fl_engine_fender_views(handle, into, Native.Length(into)));
        }

        public byte[] Save()
        {
            UIntPtr length;
            Native.Must(Native.fl_engine_save(handle, null, UIntPtr.Zero, out length));
            var bytes = new byte[(int)length];
            Native.Must(Native.fl_engine_save(handle, bytes, length, out length));
            return bytes;
        }

        public void Restore(byte[] saved)
        {
            Native.Must(Native.fl_engine_restore(handle, saved, Native.Length(saved)));
        }

        public void Reset() { Native.Must(Native.fl_engine_reset(handle)); }

        /// <summary>Keeps at least the last steps for Dump(); 0 ends it.</summary>
        public void Record(int steps) { Native.Must(Native.fl_engine_record(handle, (UIntPtr)(ulong)steps)); }

        /// <summary>The recorded steps as a file that `fenderline replay` reads.</summary>
        public byte[] Dump()
        {
            UIntPtr length;
            Native.Must(Native.fl_engine_dump(handle, null, UIntPtr.Zero, out length));
            var bytes = new byte[(int)length];
            Native.Must(Native.fl_engine_dump(handle, bytes, length, out length));
            return bytes;
        }

        /// <summary>Replays a dump; returns the number of steps that did not end with the recorded bits.</summary>
        public static int Replay(byte[] dump, out int steps)
        {
            UIntPtr all, different;
            Native.Must(Native.fl_replay_dump(dump, Native.Length(dump), out all, out different, IntPtr.Zero));
            steps = (int)all;
            return (int)different;
        }
    }

    /// <summary>Outlines from the points of a mesh.</summary>
    public static class Outlines
    {
        public static Point[] Hull(Point[] points)
        {
            UIntPtr count;
            var made = new Point[points.Length];
            Native.Must(Native.fl_outline_hull(points, Native.Length(points), made, Native.Length(made), out count));
            Array.Resize(ref made, (int)count);
            return made;
        }

        /// <summary>The whole outline of a ship from her starboard side.</summary>
        public static Point[] Mirrored(Point[] side, double toleranceM)
        {
            UIntPtr count;
            var made = new Point[2 * side.Length];
            Native.Must(Native.fl_outline_mirror(side, Native.Length(side), toleranceM, made, Native.Length(made),
                out count));
            Array.Resize(ref made, (int)count);
            return made;
        }

        /// <summary>The outline with fewer vertices, none of the given farther away than the tolerance.</summary>
        public static Point[] Simplified(Point[] outline, double toleranceM)
        {
            UIntPtr count;
            var made = new Point[outline.Length];
            Native.Must(Native.fl_outline_simplify(outline, Native.Length(outline), toleranceM, made,
                Native.Length(made), out count));
            Array.Resize(ref made, (int)count);
            return made;
        }
    }

    /// <summary>
    /// Unity's frame: left-handed, y up, x east, z north, relative to an origin in double, so that what remains fits into float.
    /// Unity's yaw in degrees, Quaternion.Euler(0, yaw, 0), is the heading in degrees; her local z is forward, x starboard.
    /// </summary>
    public static class UnityFrame
    {
        public static void FromEarth(double northM, double eastM, Point originM, out float x, out float z)
        {
            x = (float)(eastM - originM.Y);
            z = (float)(northM - originM.X);
        }

        public static Point ToEarth(float x, float z, Point originM)
        {
            return new Point(z + originM.X, x + originM.Y);
        }

        public static float YawDegrees(double headingRad) { return (float)(headingRad * 180.0 / Math.PI); }
    }

    internal sealed class EngineHandle : SafeHandle
    {
        public EngineHandle() : base(IntPtr.Zero, true) { }
        public override bool IsInvalid { get { return handle == IntPtr.Zero; } }
        protected override bool ReleaseHandle() { return Native.fl_engine_destroy(handle) == Status.Ok; }
    }

    internal sealed class BuilderHandle : SafeHandle
    {
        public BuilderHandle() : base(IntPtr.Zero, true) { }
        public override bool IsInvalid { get { return handle == IntPtr.Zero; } }
        protected override bool ReleaseHandle() { return Native.fl_builder_destroy(handle) == Status.Ok; }
    }

    internal static class Native
    {
        private const string Library = "fenderline";
        private const CallingConvention C = CallingConvention.Cdecl;
        /// <summary>FL_ABI_VERSION of the header for which this file was written.</summary>
        private const uint AbiVersion = 1;

        internal static void CheckVersion()
        {
            if (fl_abi_version() != AbiVersion)
                throw new InvalidOperationException("the library is not that of Fenderline.cs");
        }

        internal static void Must(Status status)
        {
            if (status == Status.Ok) return;
            UIntPtr length;
            var text = new byte[2000];
            fl_last_error(text, Length(text), out length);
            var end = Array.IndexOf(text, (byte)0);
            throw new FenderlineException(status, Encoding.UTF8.GetString(text, 0, end < 0 ? text.Length : end));
        }

        internal static byte[] Utf8(string text) { return Encoding.UTF8.GetBytes(text ?? ""); }

        internal static UIntPtr Length(Array of) { return (UIntPtr)(ulong)(of == null ? 0 : of.Length); }

        internal static UIntPtr SizeOf<T>() { return (UIntPtr)(ulong)Marshal.SizeOf(typeof(T)); }

        [DllImport(Library, CallingConvention = C)]
        internal static extern uint fl_abi_version();

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_last_error([Out] byte[] buffer, UIntPtr capacity, out UIntPtr length);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_builder_new(out BuilderHandle builder);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_builder_destroy(IntPtr builder);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_builder_add_material(BuilderHandle builder, byte[] name, UIntPtr nameLength,
            ref MaterialParts material, out uint index);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_builder_add_body(BuilderHandle builder, byte[] name, UIntPtr nameLength,
            ref BodyParts body, [In] Point[] outline, UIntPtr vertices, out uint index);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_builder_add_fender(BuilderHandle builder, byte[] name, UIntPtr nameLength,
            ref FenderParts fender, [In] Point[] curve, UIntPtr points, out uint index);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_builder_add_fender_by_keys(BuilderHandle builder, byte[] name,
            UIntPtr nameLength, byte[] keys, UIntPtr keysLength, out uint index);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_builder_add_pair(BuilderHandle builder, uint one, uint other, uint material);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_builder_add_all_other_pairs(BuilderHandle builder, uint material);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_builder_build(BuilderHandle builder, ref Settings settings,
            out EngineHandle engine);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_from_file(byte[] path, UIntPtr pathLength, byte[] overrides,
            UIntPtr overridesLength, ref Settings settings, out EngineHandle engine);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_from_text(byte[] scenario, UIntPtr scenarioLength, byte[] overrides,
            UIntPtr overridesLength, ref Settings settings, out EngineHandle engine);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_destroy(IntPtr engine);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_reset(EngineHandle engine);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_notices(EngineHandle engine, [Out] byte[] buffer, UIntPtr capacity,
            out UIntPtr length);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_body_count(EngineHandle engine, out UIntPtr count);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_fender_count(EngineHandle engine, out UIntPtr count);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_find_body(EngineHandle engine, byte[] name, UIntPtr nameLength,
            out uint body);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_find_fender(EngineHandle engine, byte[] name, UIntPtr nameLength,
            out uint fender);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_mass_matrix(EngineHandle engine, uint body, [Out] double[] matrix);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_initial_states(EngineHandle engine, [Out] State[] states,
            UIntPtr count);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_outline(EngineHandle engine, uint body, [Out] Point[] outline,
            UIntPtr capacity, out UIntPtr vertices);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_set_state(EngineHandle engine, uint body, ref State state);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_set_loads(EngineHandle engine, [In] Wrench[] loads, UIntPtr count);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_mark_teleported(EngineHandle engine, uint body);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_advance(EngineHandle engine, [In] State[] states,
            [In] Wrench[] loads, UIntPtr count, double stepS, [Out] Wrench[] wrenches);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_peak_wrenches(EngineHandle engine, [Out] Wrench[] peaks,
            UIntPtr count);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_states_after(EngineHandle engine, [Out] State[] states,
            UIntPtr count);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_contacts(EngineHandle engine, [Out] Contact[] contacts,
            UIntPtr elementSize, UIntPtr capacity, out UIntPtr count);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_events(EngineHandle engine, [Out] Event[] events,
            UIntPtr elementSize, UIntPtr capacity, out UIntPtr count);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_fender_views(EngineHandle engine, [Out] FenderView[] views,
            UIntPtr count);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_save(EngineHandle engine, [Out] byte[] buffer, UIntPtr capacity,
            out UIntPtr length);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_restore(EngineHandle engine, byte[] saved, UIntPtr length);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_record(EngineHandle engine, UIntPtr steps);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_engine_dump(EngineHandle engine, [Out] byte[] buffer, UIntPtr capacity,
            out UIntPtr length);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_replay_dump(byte[] dump, UIntPtr length, out UIntPtr steps,
            out UIntPtr different, IntPtr engine);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_outline_hull([In] Point[] points, UIntPtr count, [Out] Point[] outline,
            UIntPtr capacity, out UIntPtr vertices);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_outline_mirror([In] Point[] side, UIntPtr count, double toleranceM,
            [Out] Point[] outline, UIntPtr capacity, out UIntPtr vertices);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status fl_outline_simplify([In] Point[] points, UIntPtr count, double toleranceM,
            [Out] Point[] outline, UIntPtr capacity, out UIntPtr vertices);
    }
}
