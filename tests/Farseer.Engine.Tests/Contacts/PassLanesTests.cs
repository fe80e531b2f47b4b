using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Storage;
using FsCheck;
using FsCheck.Fluent;
using Xunit;

namespace Farseer.Engine.Tests.Contacts;

/// <summary>The passes over contact rows, with other neighbours in their vectors: no lane may know of those beside it.</summary>
public sealed unsafe class PassLanesTests
{
    private const int Lanes = ContactBundle.Lanes;
    private const int Kinds = 5;
    private const int Biased = 1;
    private const int PushOut = 4;

    [Fact]
    public void Passes_OfRowsSideBySideOrEachAlone_GiveTheSameBits() => Prop.ForAll(Gen.Choose(0, int.MaxValue).ToArbitrary(), seed =>
    {
        var packed = new Rows(seed, perBundle: Lanes);
        var alone = new Rows(seed, perBundle: 1);
        for (int kind = 0; kind < Kinds; kind++)
        {
            packed.Run(kind);
            alone.Run(kind);
            packed.AssertSame(alone, $"seed {seed}, pass {kind}", kind == PushOut);
        }
    }).QuickCheckThrowOnFailure();

#if !NETSTANDARD_ASSET
    [SixteenLanesFact]
    public void Passes_OnSixteenLanes_GiveTheBitsOfEight() => Prop.ForAll(Gen.Choose(0, int.MaxValue).ToArbitrary(), seed =>
    {
        var eight = new Rows(seed, perBundle: Lanes);
        var sixteen = new Rows(seed, perBundle: Lanes);
        for (int kind = 0; kind < Kinds; kind++)
        {
            eight.Run(kind);
            sixteen.RunOnSixteen(kind);
            eight.AssertSame(sixteen, $"seed {seed}, pass {kind}", kind == PushOut);
        }
    }).QuickCheckThrowOnFailure();
#endif

    [Fact]
    public void Passes_OfRowsThatMayShareABody_FindTheImpulsesOfTheOthers() =>
        Prop.ForAll(Gen.Choose(0, int.MaxValue).ToArbitrary(), seed =>
    {
        for (int kind = 0; kind < Kinds; kind++)
        {
            var plain = new Rows(seed, perBundle: Lanes);
            var shared = new Rows(seed, perBundle: Lanes);
            plain.Run(kind);
            shared.RunShared(kind);

            // A change is added where others write the sum.
            shared.AssertNear(plain, 4e-6f, $"seed {seed}, pass {kind}");
        }
    }).QuickCheckThrowOnFailure();

    [Fact]
    public void Passes_OfRowsWithOneHeavyBody_KeepMomentum() => Prop.ForAll(Gen.Choose(0, int.MaxValue).ToArbitrary(), seed =>
    {
        for (int kind = 0; kind < Kinds; kind++)
        {
            var rows = new Rows(seed, perBundle: Lanes);
            rows.ShareFirst(1e-3f);
            (double x, double y) = rows.Momentum();
            rows.RunShared(kind);
            (double newX, double newY) = rows.Momentum();

            // The heavy body has a mass of 1,000 and 2 m/s: half of its last place is 6e-5, once a row.
            Assert.True(
                Math.Abs(newX - x) + Math.Abs(newY - y) < 2e-4 * (rows.Count + 1), $"seed {seed}, pass {kind}: {newX - x}, {newY - y}");
        }
    }).QuickCheckThrowOnFailure();

    [Fact]
    public void Blow_BesideAnother_IsNotStruckItselfIfItHasAFeedForward()
    {
        // Both are new by their last impulse; the second pushes for long by its feed-forward. It was turned as by a blow if its vector had
        // one.
        var both = new Rows(0, perBundle: Lanes, count: 2);
        var alone = new Rows(0, perBundle: 1, count: 2);
        foreach (Rows rows in new[] { both, alone })
        {
            for (int i = 0; i < 2; i++)
            {
                ContactBundle* row = rows.Row(i, out int lane);
                row->Flags[lane] = ContactBundle.SingleMark;
                row->Point0.PreviousNormal[lane] = row->Point1.PreviousNormal[lane] = 0;
                row->Point0.Feed[lane] = i;
                row->Point0.Base[lane] = 0.5f;
                row->InertiaB[lane] = 4;
                rows.Turn(i, 0.2f);
            }

            rows.Run(Biased);
            Assert.NotEqual(0, rows.Spin(0));
        }

        both.AssertSame(alone, "blow");
    }

    /// <summary>Contacts of one colour between bodies at random.</summary>
    private sealed class Rows
    {
        private readonly Column<ContactBundle> _records;
        private readonly Column<nint> _places;
        private readonly Column<ushort> _fresh;
        private readonly Column<BodyState> _states;
        private readonly ContactCoefficients _coefficients = new ContactCoefficients(1f / 240, 10, 1);
        private readonly int _perBundle;
        private readonly int _bundles;
        private readonly bool _grounded;
        private readonly bool _onePoint;

        public Rows(int seed, int perBundle, int count = 0)
        {
            var random = new Random(seed);
            _perBundle = perBundle;
            Count = count == 0 ? random.Next(1, 12 * Lanes) : count;
            _grounded = count == 0 && random.Next(3) == 0;
            _onePoint = count == 0 && random.Next(3) == 0;
            _bundles = (Count + perBundle - 1) / perBundle;
            _records = new Column<ContactBundle>((_bundles / ContactBundle.Beside) + 1);
            _places = new Column<nint>(_bundles + BundleList.PlacesBehind);
            _fresh = new Column<ushort>(_bundles);
            for (int i = 0; i < _bundles; i++)
            {
                // A pass that no warm start precedes asks the rows.
                _fresh[i] = ushort.MaxValue;
            }

            for (int i = 0; i < _records.Capacity; i++)
            {
                ContactLanes.ClearRecord(_records.Pointer + i);
            }

            _states = new Column<BodyState>((2 * Count) + 1);
            _states[0].DeltaCos = 1;
            for (int i = 1; i <= 2 * Count; i++)
            {
                bool still = random.Next(4) == 0;
                float angle = random.Next(8) == 0 ? Next(random, 1) : Next(random, 0.1f);
                _states[i] = new BodyState
                {
                    LinearVelocity = still ? new Vector2(-0f, 0f) : new Vector2(Next(random, 2), Next(random, 2)),
                    AngularVelocity = still ? -0f : Next(random, 5),
                    DeltaPosition = new Vector2(Next(random, 0.01f), Next(random, 0.01f)),
                    DeltaSin = MathF.Sin(angle),
                    DeltaCos = MathF.Cos(angle),
                };
            }

            for (int i = 0; i < Count; i++)
            {
                Fill(random, i);
            }
        }

        public int Count { get; }

        public ContactBundle* Row(int index, out int lane)
        {
            lane = index % _perBundle;
            return ContactBundle.At(_records.Pointer, index / _perBundle);
        }

        public void Turn(int index, float angle)
        {
            ref BodyState state = ref _states[2 + (2 * index)];
            state.LinearVelocity = new Vector2(0, -1);
            state.AngularVelocity = 0;
            state.DeltaSin = MathF.Sin(angle);
            state.DeltaCos = MathF.Cos(angle);
        }

        public float Spin(int index) => _states[2 + (2 * index)].AngularVelocity;

        public void Run(int kind) => PassChoice.Run(Pass(kind), List(), _grounded, _onePoint);

        public void RunShared(int kind) => SharedKernel.Run(Pass(kind), List());

        /// <summary>Gives all rows the first body of the first one, which then is so heavy.</summary>
        public void ShareFirst(float inverseMass)
        {
            for (int i = 0; i < Count; i++)
            {
                ContactBundle* row = Row(i, out int lane);
                row->BodyA[lane] = 1;
                row->MassA[lane] = inverseMass;
                row->InertiaA[lane] = inverseMass;
                row->K11[lane] = Response(row, &row->Point0, lane);
                row->K22[lane] = (row->Flags[lane] & ContactBundle.SingleMark) != 0 ? row->K11[lane] : Response(row, &row->Point1, lane);
            }
        }

        /// <summary>That of the second bodies of all rows and of the first body of the first.</summary>
        public (double X, double Y) Momentum()
        {
            ContactBundle* first = Row(0, out int firstLane);
            double x = _states[1].LinearVelocity.X / (double)first->MassA[firstLane];
            double y = _states[1].LinearVelocity.Y / (double)first->MassA[firstLane];
            for (int i = 0; i < Count; i++)
            {
                ContactBundle* row = Row(i, out int lane);
                x += _states[row->BodyB[lane]].LinearVelocity.X / (double)row->MassB[lane];
                y += _states[row->BodyB[lane]].LinearVelocity.Y / (double)row->MassB[lane];
            }

            return (x, y);
        }

        /// <summary>The same impulses, and velocities that are no further apart than a share of what they are.</summary>
        public void AssertNear(Rows other, float share, string what)
        {
            for (int i = 1; i <= 2 * Count; i++)
            {
                ref BodyState a = ref _states[i];
                ref BodyState b = ref other._states[i];
                float most = share * (1 + b.LinearVelocity.Length() + Math.Abs(b.AngularVelocity));
                Assert.True(
                    (a.LinearVelocity - b.LinearVelocity).Length() <= most && Math.Abs(a.AngularVelocity - b.AngularVelocity) <= most,
                    $"{what}: body {i} of {2 * Count}");
            }

            AssertSameRows(other, what);
        }

#if !NETSTANDARD_ASSET
        public void RunOnSixteen(int kind)
        {
            int records = (_bundles + 1) / ContactBundle.Beside;
            var list = (Engine.Contacts.Sixteen.ContactBundle**)Places(records, ContactBundle.Beside);
            var rows = new Engine.Contacts.Sixteen.BundleList(list, _fresh.Pointer, records, isFar: false);
            Engine.Contacts.Sixteen.PassChoice.Run(Pass(kind), rows, _grounded, _onePoint);
        }
#endif

        private BundleList List() => new BundleList((ContactBundle**)Places(_bundles, 1), _fresh.Pointer, _bundles, isFar: false);

        /// <summary>Every bundle, or every so many-th, and the last of them again behind it.</summary>
        private nint* Places(int count, int step)
        {
            for (int i = 0; i < _places.Capacity; i++)
            {
                _places[i] = (nint)ContactBundle.At(_records.Pointer, step * Math.Min(i, count - 1));
            }

            return _places.Pointer;
        }

        /// <summary>
        /// Velocities that overlaps go with are forgotten when the bodies were moved: there 0 may be -0, which moves nothing else.
        /// </summary>
        public void AssertSame(Rows other, string what, bool zerosAlike = false)
        {
            for (int i = 1; i <= 2 * Count; i++)
            {
                BodyState a = _states[i];
                BodyState b = other._states[i];
                bool same = zerosAlike
                    ? a.LinearVelocity == b.LinearVelocity && a.AngularVelocity == b.AngularVelocity
                    : Bits(_states, i).SequenceEqual(Bits(other._states, i));
                Assert.True(same, $"{what}: body {i} of {2 * Count}");
            }

            AssertSameRows(other, what);
        }

        private void AssertSameRows(Rows other, string what)
        {
            for (int i = 0; i < Count; i++)
            {
                ContactBundle* row = Row(i, out int lane);
                ContactBundle* same = other.Row(i, out int otherLane);
                for (int column = 0; column < ContactBundle.Bytes / sizeof(int); column += ContactBundle.LineLanes)
                {
                    Assert.True(
                        ((int*)row)[column + lane] == ((int*)same)[column + otherLane],
                        $"{what}: column {column / ContactBundle.LineLanes} of row {i} of {Count}");
                }
            }
        }

        private static ReadOnlySpan<byte> Bits(Column<BodyState> states, int index) =>
            new ReadOnlySpan<byte>(states.Pointer + index, sizeof(BodyState));

        private static float Next(Random random, float most) => most * (float)((2 * random.NextDouble()) - 1);

        private ContactPass Pass(int kind) => new ContactPass
        {
            Kind = kind switch
            {
                0 => ContactPassKind.WarmStart,
                Biased => ContactPassKind.Biased,
                PushOut => ContactPassKind.PushOut,
                _ => ContactPassKind.Relax,
            },
            States = _states.Pointer,
            Coefficients = _coefficients,
            Flag = kind < 3,
            First = kind == 2,
            Rate = 60,
        };

        private void Fill(Random random, int index)
        {
            ContactBundle* row = Row(index, out int lane);
            bool single = _onePoint || random.Next(3) == 0;
            float angle = Next(random, 4);
            row->BodyA[lane] = _grounded ? 0 : 1 + (2 * index);
            row->BodyB[lane] = 2 + (2 * index);
            row->NormalX[lane] = MathF.Cos(angle);
            row->NormalY[lane] = MathF.Sin(angle);
            row->MassA[lane] = _grounded ? 0 : 1;
            row->InertiaA[lane] = _grounded ? 0 : 3;
            row->MassB[lane] = 1.5f;
            row->InertiaB[lane] = random.Next(5) == 0 ? 0 : 4;
            row->RadiusA[lane] = random.Next(2) * 0.1f;
            row->Friction[lane] = random.Next(3) * 0.4f;
            row->FeedRate[lane] = 0.1f;
            row->FeedShare[lane] = 0.9f;
            row->Flags[lane] = (single ? ContactBundle.SingleMark : 0)
                | (random.Next(4) == 0 ? ContactBundle.DeepMark : 0)
                | (random.Next(3) != 0 ? ContactBundle.BlockMark : 0);
            FillPoint(random, &row->Point0, lane, 0.5f);
            if (!single)
            {
                FillPoint(random, &row->Point1, lane, -0.5f);
            }

            row->K11[lane] = Response(row, &row->Point0, lane);
            row->K22[lane] = single ? row->K11[lane] : Response(row, &row->Point1, lane);
        }

        private static float Response(ContactBundle* row, ContactPointLanes* point, int lane) => row->MassA[lane] + row->MassB[lane]
            + (row->InertiaA[lane] * point->TangentArmA[lane] * point->TangentArmA[lane])
            + (row->InertiaB[lane] * point->TangentArmB[lane] * point->TangentArmB[lane]);

        private static void FillPoint(Random random, ContactPointLanes* point, int lane, float arm)
        {
            bool fresh = random.Next(3) == 0;
            point->TangentArmA[lane] = arm + Next(random, 0.2f);
            point->TangentArmB[lane] = arm + Next(random, 0.2f);
            point->NormalArmA[lane] = 0.5f + Next(random, 0.1f);
            point->NormalArmB[lane] = -0.5f + Next(random, 0.1f);
            point->Base[lane] = 1 + Next(random, 0.02f);
            point->Normal[lane] = fresh ? 0 : (float)random.NextDouble();
            point->PreviousNormal[lane] = fresh ? 0 : (float)random.NextDouble();
            point->Tangent[lane] = fresh ? 0 : Next(random, 0.3f);
            point->PreviousTangent[lane] = fresh ? 0 : Next(random, 0.3f);
            point->Feed[lane] = random.Next(2) * 0.2f;
        }
    }
}
