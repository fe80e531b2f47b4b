using System;
using System.Numerics;
using BenchmarkDotNet.Attributes;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Storage;

namespace Farseer.Benchmarks.Suites;

/// <summary>
/// The kernels of a contact alone, ns a contact: rows of two points between boxes one upon the other, each body in one row.
/// </summary>
public unsafe class KernelSuite
{
    private const int Contacts = 4096;
    private const int Bundles = Contacts / ContactBundle.Lanes;
    private readonly Column<ContactBundle> _rows = new Column<ContactBundle>(Bundles);
    private readonly Column<nint> _list = new Column<nint>(Bundles + BundleList.PlacesBehind);
    private readonly Column<ushort> _fresh = new Column<ushort>(Bundles);
    private readonly Column<BodyState> _states = new Column<BodyState>((2 * Contacts) + 1);
    private readonly Column<PairLanes> _pairs = new Column<PairLanes>(1);
    private ContactCoefficients _coefficients;

    /// <summary>Lanes of the vectors that the passes over contacts go by: all that this processor has.</summary>
#if NETSTANDARD_ASSET
    public static int[] Widths => [Vector<float>.Count];
#else
    public static int[] Widths => Engine.Numerics.Sixteen.WideLanes.AreThere ? [8, 16] : [8];
#endif

    [ParamsSource(nameof(Widths))]
    public int Lanes { get; set; }

    [GlobalSetup]
    public void Setup()
    {
        _coefficients = new ContactCoefficients(1f / 240, 10, 1);
        for (int i = 0; i < _states.Capacity; i++)
        {
            _states[i] = new BodyState { LinearVelocity = new Vector2(0.01f * (i % 7), 0.01f * (i % 5)), DeltaCos = 1 };
        }

        for (int i = 0; i < Contacts; i++)
        {
            ContactBundle* row = ContactBundle.At(_rows.Pointer, i / ContactBundle.Lanes);
            int lane = i % ContactBundle.Lanes;
            ContactLanes.ClearLane(row, lane);
            row->BodyA[lane] = 1 + (2 * i);
            row->BodyB[lane] = 2 + (2 * i);
            row->NormalY[lane] = 1;

            // The bodies of no mass keep their speed: those of any would come to rest, and the passes on the smallest of numbers are slow.
            row->K11[lane] = row->K22[lane] = 5;
            row->Friction[lane] = 0.6f;
            SetPoint(&row->Point0, lane, 0.5f);
            SetPoint(&row->Point1, lane, -0.5f);
        }

        int beside = Lanes / ContactBundle.Lanes;
        for (int i = 0; i < _list.Capacity; i++)
        {
            _list[i] = (nint)ContactBundle.At(_rows.Pointer, beside * Math.Min(i, (Bundles / beside) - 1));
        }

        SetSide(&_pairs.Pointer->A, 0);
        SetSide(&_pairs.Pointer->B, 0.999f);
        for (int lane = 0; lane < PairLanes.Lanes; lane++)
        {
            _pairs.Pointer->Margin[lane] = 0.02f;
        }
    }

    [Benchmark(OperationsPerInvoke = Contacts)]
    public void WarmStart() => Run(ContactPassKind.WarmStart);

    [Benchmark(OperationsPerInvoke = Contacts)]
    public void SolveBiased() => Run(ContactPassKind.Biased);

    [Benchmark(OperationsPerInvoke = Contacts)]
    public void Relax() => Run(ContactPassKind.Relax);

    [Benchmark(OperationsPerInvoke = PairLanes.Lanes)]
    public int BoxBox() => WideBoxBox.Collide(_pairs.Pointer);

    [Benchmark(OperationsPerInvoke = PairLanes.Lanes)]
    public void CircleCircle() => WideCircleCircle.Collide(_pairs.Pointer);

    private void Run(ContactPassKind kind)
    {
        var pass = new ContactPass
        {
            Kind = kind,
            States = _states.Pointer,
            Coefficients = _coefficients,
            Flag = kind == ContactPassKind.Relax,
            First = true,
        };
#if !NETSTANDARD_ASSET
        if (Lanes == Engine.Contacts.Sixteen.ContactBundle.Lanes)
        {
            var list = (Engine.Contacts.Sixteen.ContactBundle**)_list.Pointer;
            var records = new Engine.Contacts.Sixteen.BundleList(list, _fresh.Pointer, Bundles / ContactBundle.Beside, isFar: false);
            Engine.Contacts.Sixteen.PassChoice.Run(pass, records, grounded: false, onePoint: false);
            return;
        }
#endif
        PassChoice.Run(
            pass, new BundleList((ContactBundle**)_list.Pointer, _fresh.Pointer, Bundles, isFar: false), grounded: false, onePoint: false);
    }

    private static void SetPoint(ContactPointLanes* point, int lane, float arm)
    {
        point->TangentArmA[lane] = arm;
        point->TangentArmB[lane] = arm;
        point->NormalArmA[lane] = 0.5f;
        point->NormalArmB[lane] = -0.5f;
        point->Base[lane] = 1;
    }

    private static void SetSide(SideLanes* side, float height)
    {
        for (int lane = 0; lane < PairLanes.Lanes; lane++)
        {
            side->X[lane] = 0.1f * lane * height;
            side->Y[lane] = height;
            side->Cos[lane] = 1;
            side->Sin[lane] = 0;
            side->HalfX[lane] = 0.5f;
            side->HalfY[lane] = 0.5f;
            side->Extent[lane] = 0.5f;
        }
    }
}
