using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Contacts;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Settings;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;
using Farseer.Engine.Tests.NarrowPhase;
using FsCheck;
using FsCheck.Fluent;
using Xunit;

namespace Farseer.Engine.Tests.Contacts;

/// <summary>The update of pairs that have rows, with other neighbours in their vectors: no lane may know of those beside it.</summary>
public sealed unsafe class UpdateLanesTests
{
    private const int Lanes = ContactBundle.Lanes;
    private const int Pairs = ContactBundle.LineLanes;

    [Fact]
    public void Update_OfPairsSideBySideOrEachAlone_GivesTheSameBits() => Prop.ForAll(Gen.Choose(0, int.MaxValue).ToArbitrary(), seed =>
    {
        var packed = new Scene(seed);
        packed.Update();
        for (int pair = 0; pair < Pairs; pair++)
        {
            var alone = new Scene(seed, only: pair);
            alone.Update();
            packed.AssertSame(alone, pair, $"seed {seed}");
        }
    }).QuickCheckThrowOnFailure();

#if !NETSTANDARD_ASSET
    [SixteenLanesFact]
    public void Update_OnSixteenLanes_GivesTheBitsOfEight() => Prop.ForAll(Gen.Choose(0, int.MaxValue).ToArbitrary(), seed =>
    {
        var eight = new Scene(seed);
        var sixteen = new Scene(seed);
        eight.Update();
        sixteen.UpdateOnSixteen();
        for (int pair = 0; pair < Pairs; pair++)
        {
            eight.AssertSame(sixteen, pair, $"seed {seed}");
        }
    }).QuickCheckThrowOnFailure();
#endif

    [Fact]
    public void Update_OfPairsAtRandom_FindsAllFates()
    {
        ContactFates found = default;
        for (int seed = 0; seed < 200; seed++)
        {
            var scene = new Scene(seed);
            scene.Update();
            for (int bundle = 0; bundle < ContactBundle.Beside; bundle++)
            {
                ContactFates fates = scene.Fates(bundle);
                found.Dropped |= fates.Dropped;
                found.Solid |= fates.Solid;
                found.Idle |= fates.Idle;
                found.TouchingNow |= fates.TouchingNow;
                found.Heard |= fates.Heard;
                found.Blows |= fates.Blows;
                found.Hulls |= fates.Hulls;
                found.Deferred |= fates.Deferred;
                found.Racing |= fates.Racing;
            }
        }

        Assert.All(
            new[] {
                found.Dropped, found.Solid, found.Idle, found.TouchingNow, found.Heard, found.Blows, found.Hulls, found.Deferred,
                found.Racing,
            },
            fate => Assert.NotEqual(0, fate));
    }

    /// <summary>A record of pairs between bodies at random: in most seeds boxes, in others whatever there is.</summary>
    private sealed class Scene
    {
        private readonly Column<ContactBundle> _record = new Column<ContactBundle>(1);
        private readonly Column<PairLanes> _pairs = new Column<PairLanes>(1);
        private readonly Column<byte> _moves = new Column<byte>((2 * Pairs) + 1);
        private readonly Column<Box> _fat = new Column<Box>((2 * Pairs) + 1);
        private readonly Column<ProxyInfo> _proxies = new Column<ProxyInfo>((2 * Pairs) + 1);
        private readonly BodyStore _bodies = new BodyStore();
        private readonly ShapeStore _shapes = new ShapeStore();
        private readonly Scratch _scratch = new Scratch();
        private readonly ContactSides _sides = new ContactSides();
        private readonly ContactStore _contacts;
        private readonly ContactFates[] _fates = new ContactFates[ContactBundle.Beside];
        private ContactUpdateInput _input;

        /// <param name="seed">All follows from it.</param>
        /// <param name="only">The one pair that there is; -1: all.</param>
        public Scene(int seed, int only = -1)
        {
            var random = new Random(seed);
            _contacts = new ContactStore(_shapes);
            _contacts.Records.EnsureCapacity(Pairs);
            _contacts.KeepManifolds();
            _bodies.Set.EnsureCapacity((2 * Pairs) + 1);
            _bodies.State[0] = new BodyState { DeltaCos = 1 };
            _bodies.Pose[0] = new BodyPose { Cos = 1 };
            ContactLanes.ClearRecord(_record.Pointer);
            bool boxes = random.Next(3) != 0;
            bool plain = random.Next(2) == 0;
            for (int pair = 0; pair < Pairs; pair++)
            {
                Place(random, pair, boxes, plain);
                bool exists = random.Next(8) != 0 && (only < 0 || only == pair);
                int numbers = random.Next();
                if (exists)
                {
                    Name(new Random(numbers), pair);
                }
            }

            _input = Input(random);
        }

        public ContactFates Fates(int bundle) => _fates[bundle];

        public void Update()
        {
            for (int i = 0; i < ContactBundle.Beside; i++)
            {
                ContactUpdateInput input = _input;
                input.Pairs = i == 0 ? _pairs.Pointer : PairLanes.Beside(_pairs.Pointer);
                ContactUpdate.UpdateRows(input, ContactBundle.At(_record.Pointer, i), out _fates[i]);
            }
        }

#if !NETSTANDARD_ASSET
        public void UpdateOnSixteen()
        {
            ContactUpdate.UpdateRecord(_input, _record.Pointer, out ContactFates both);
            for (int i = 0; i < ContactBundle.Beside; i++)
            {
                _fates[i] = both.OfBundle(i);
            }
        }
#endif

        /// <summary>Of a pair that goes on giving impulses its row, of all what is to become of them.</summary>
        public void AssertSame(Scene other, int pair, string what)
        {
            int lane = pair % Lanes;
            ContactBundle* row = ContactBundle.At(_record.Pointer, pair / Lanes);
            ContactBundle* same = ContactBundle.At(other._record.Pointer, pair / Lanes);
            if (row->Contact[lane] < 0 || same->Contact[lane] < 0)
            {
                return;
            }

            ContactFates fates = _fates[pair / Lanes];
            int bit = 1 << lane;
            Assert.True(AreSame(fates, other._fates[pair / Lanes], bit), $"{what}: fate of pair {pair}");
            Assert.Equal(_contacts.Records[pair].Flags, other._contacts.Records[pair].Flags);
            if ((fates.Heard & bit) != 0)
            {
                Assert.Equal(_contacts.Manifolds[pair], other._contacts.Manifolds[pair]);
            }

            if ((fates.Blows & bit) != 0)
            {
                Assert.Equal(_pairs.Pointer->Sinking[pair], other._pairs.Pointer->Sinking[pair]);
            }

            if ((fates.Solid & bit) == 0)
            {
                return;
            }

            for (int column = 0; column < ContactBundle.Bytes / sizeof(int); column += ContactBundle.LineLanes)
            {
                Assert.True(
                    ((int*)row)[column + lane] == ((int*)same)[column + lane],
                    $"{what}: column {column / ContactBundle.LineLanes} of pair {pair}");
            }
        }

        private static bool AreSame(in ContactFates a, in ContactFates b, int bit) =>
            (((a.Dropped ^ b.Dropped) | (a.Solid ^ b.Solid) | (a.Idle ^ b.Idle) | (a.Touching ^ b.Touching)
            | (a.TouchingNow ^ b.TouchingNow)
                | (a.Heard ^ b.Heard) | (a.Blows ^ b.Blows) | (a.Hulls ^ b.Hulls) | (a.Deferred ^ b.Deferred) | (a.Racing ^ b.Racing))
                & bit) == 0;

        private static float Next(Random random, float most) => most * (float)((2 * random.NextDouble()) - 1);

        private void Place(Random random, int pair, bool boxes, bool plain)
        {
            double angle = random.NextDouble() * 7;
            Vector2 apart = 1.4f * RandomShape.Point(random);
            for (int side = 0; side < 2; side++)
            {
                int body = 1 + (2 * pair) + side;
                ShapeGeometry shape = boxes
                    ? ShapeBuilder.Box(RandomShape.Between(random, 0.5, 1.5), RandomShape.Between(random, 0.5, 1.5))
                    : RandomShape.Any(random);
                int piece = _shapes.AttachPieces(shape, body, body, Vector2.Zero, Rotation.Identity);
                ref ColliderInfo collider = ref _shapes.Colliders[body];
                bool ghost = !plain && random.Next(12) == 0;
                bool heard = !plain && random.Next(6) == 0;
                collider.Flags = (ghost ? ColliderFlags.None : ColliderFlags.ResponseEnabled)
                    | (heard ? ColliderFlags.WantsContact : ColliderFlags.None);
                collider.Friction = (float)random.NextDouble();
                collider.Restitution = random.Next(2) * 0.3f;
                bool still = random.Next(5) == 0;
                bool fast = !plain && !still && random.Next(10) == 0;
                angle = side == 0 || random.Next(3) == 0 ? random.NextDouble() * 7 : angle + (0.02 * random.NextDouble());
                _moves[body] = still ? (byte)0 : (byte)1;
                _bodies.Flags[body] =
                    BodyFlags.Alive | (still ? BodyFlags.Static : BodyFlags.None) | (fast ? BodyFlags.Fast : BodyFlags.None);
                _bodies.Mass[body] = new BodyMass { InverseMass = 1 + side, InverseInertia = 3 };
                _bodies.Pose[body] = new BodyPose
                {
                    X = 1000 + (side * apart.X),
                    Y = side * apart.Y,
                    Angle = angle,
                    Cos = (float)Math.Cos(angle),
                    Sin = (float)Math.Sin(angle),
                };
                float speed = fast ? 90 : random.Next(6) == 0 ? 20 : 1;
                _bodies.State[body] = still
                    ? new BodyState { DeltaCos = 1 }
                    : new BodyState { LinearVelocity = speed * RandomShape.Point(random), AngularVelocity = Next(random, 5), DeltaCos = 1 };
                bool parted = !plain && random.Next(8) == 0;
                _proxies[piece] = new ProxyInfo { Body = body, Flags = random.Next(3) == 0 ? ProxyFlags.Moved : ProxyFlags.None };
                float x = parted ? 100 * side : 0;
                _fat[piece] = new Box(x - 1, -1, x + 1, 1);
                _contacts.Records[pair].BodyA = side == 0 ? body : _contacts.Records[pair].BodyA;
                _contacts.Records[pair].PieceA = side == 0 ? piece : _contacts.Records[pair].PieceA;
                _contacts.Records[pair].BodyB = body;
                _contacts.Records[pair].PieceB = piece;
            }
        }

        private void Name(Random random, int pair)
        {
            int lane = pair % Lanes;
            ContactBundle* row = ContactBundle.At(_record.Pointer, pair / Lanes);
            ref ContactRecord record = ref _contacts.Records[pair];
            record.Flags = (random.Next(2) == 0 ? ContactFlags.Touching : ContactFlags.None) | ContactFlags.Solid;
            ContactLanes.Name(row, lane, pair, record);
            row->Flags[lane] |= random.Next(4) == 0 ? ContactBundle.DeepMark : 0;

            // Those of the points that boxes have, so that some impulses find theirs again, crosswise or not.
            row->Id0[lane] = EdgeId(random);
            row->Id1[lane] = EdgeId(random);
            FillPoint(random, &row->Point0, lane);
            FillPoint(random, &row->Point1, lane);
        }

        private static uint EdgeId(Random random) => (uint)((random.Next(4) << 16) | (random.Next(4) << 1) | 1);

        private static void FillPoint(Random random, ContactPointLanes* point, int lane)
        {
            point->Normal[lane] = (float)random.NextDouble();
            point->PreviousNormal[lane] = (float)random.NextDouble();
            point->Tangent[lane] = Next(random, 0.3f);
            point->PreviousTangent[lane] = Next(random, 0.3f);
            point->Feed[lane] = random.Next(2) * 0.2f;
        }

        private ContactUpdateInput Input(Random random)
        {
            _sides.Begin(_shapes, null, maySleep: false, _scratch);
            _sides.Prepare(_shapes, _bodies, _proxies.Pointer, _moves.Pointer, 0, _shapes.PieceIds.End);
            var settings = new WorldSettings
            {
                Gravity = new Vector2(0, -10),
                AllowedPenetration = random.Next(2) * 0.01f,
                FrictionMix = (FrictionMix)random.Next(3),
                RestitutionMix = (RestitutionMix)random.Next(2),
                CorrectPositions = random.Next(4) != 0,
            };
            return new ContactUpdateInput
            {
                Shapes = _shapes,
                Bodies = _bodies,
                Contacts = _contacts,
                Fat = _fat.Pointer,
                Proxies = _proxies.Pointer,
                Sides = _sides.Pointer,
                Hulls = _sides.Hulls,
                Pairs = _pairs.Pointer,
                Moves = _moves.Pointer,
                Settings = settings,
                Scratch = _scratch,
                Dt = 1f / 60,
                ImpulseScale = random.Next(2) == 0 ? 1 : 0.8f,
                LoadGrowth = random.Next(2) * 0.25f,
                Coefficients = new ContactCoefficients(1f / 240, 10, 1),
            };
        }
    }
}
