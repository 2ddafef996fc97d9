using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Picking
{
    /// <summary>
    /// The rays of a picture, in LPS millimetres and double precision: P(t) = Origin + x * OriginDx + y * OriginDy + t * (Direction + x * DirectionDx +
    /// y * DirectionDy), with x to the right and y upwards in pixels. A pixel's ray goes through its centre, which is column + 0.5 and row + 0.5; row
    /// 0 is the bottom row. Pixels are square. Immutable.
    /// </summary>
    public sealed class PictureRays
    {
        /// <summary>The largest width and height of a picture, in pixels.</summary>
        public const int MaxSize = 16384;

        const double SmallestSine = 1e-9;

        /// <summary>Takes rays as they are, for cameras that are neither perspective nor orthographic (off-centre views of a headset).</summary>
        /// <param name="origin">Origin at x = y = 0, LPS millimetres.</param>
        /// <param name="originDx">Change of the origin per pixel to the right.</param>
        /// <param name="originDy">Change of the origin per pixel upwards.</param>
        /// <param name="direction">Direction at x = y = 0, of any length.</param>
        /// <param name="directionDx">Change of the direction per pixel to the right.</param>
        /// <param name="directionDy">Change of the direction per pixel upwards.</param>
        /// <param name="width">Pixels, 1 to <see cref="MaxSize"/>.</param>
        /// <param name="height">Pixels, 1 to <see cref="MaxSize"/>.</param>
        /// <param name="nearT">The smallest t that is looked at, 0 or more.</param>
        /// <param name="farT">The largest t that is looked at, not below <paramref name="nearT"/>; may be infinite.</param>
        /// <exception cref="ArgumentException">A number lies outside its range.</exception>
        public PictureRays(
            PointMm origin, VectorMm originDx, VectorMm originDy, VectorMm direction, VectorMm directionDx, VectorMm directionDy,
            int width, int height, double nearT = 0, double farT = double.PositiveInfinity)
        {
            if (!origin.IsFinite || !originDx.IsFinite || !originDy.IsFinite || !direction.IsFinite || !directionDx.IsFinite || !directionDy.IsFinite)
                throw new ArgumentException("A picture's rays are made of finite numbers.", nameof(origin));
            CheckSize(width, nameof(width));
            CheckSize(height, nameof(height));
            if (!(nearT >= 0) || double.IsInfinity(nearT) || !(farT >= nearT))
                throw new ArgumentException(FormattableString.Invariant(
                    $"The range of t begins at 0 or later, ends not before that and is no NaN; it is {nearT} to {farT}."), nameof(nearT));
            Origin = origin;
            OriginDx = originDx;
            OriginDy = originDy;
            Direction = direction;
            DirectionDx = directionDx;
            DirectionDy = directionDy;
            Width = width;
            Height = height;
            NearT = nearT;
            FarT = farT;
        }

        /// <summary>The rays' origin at x = y = 0 (the outer corner of the lower left pixel), LPS millimetres.</summary>
        public PointMm Origin { get; }

        /// <summary>The origin's change per pixel to the right, millimetres; zero in perspective.</summary>
        public VectorMm OriginDx { get; }

        /// <summary>The origin's change per pixel upwards, millimetres; zero in perspective.</summary>
        public VectorMm OriginDy { get; }

        /// <summary>The rays' direction at x = y = 0, millimetres per t.</summary>
        public VectorMm Direction { get; }

        /// <summary>The direction's change per pixel to the right; zero in orthographic pictures.</summary>
        public VectorMm DirectionDx { get; }

        /// <summary>The direction's change per pixel upwards; zero in orthographic pictures.</summary>
        public VectorMm DirectionDy { get; }

        /// <summary>Pixels per row.</summary>
        public int Width { get; }

        /// <summary>Rows.</summary>
        public int Height { get; }

        /// <summary>The smallest t that is looked at.</summary>
        public double NearT { get; }

        /// <summary>The largest t that is looked at; may be infinite.</summary>
        public double FarT { get; }

        /// <summary>A perspective view. t is the depth in millimetres along the view's axis.</summary>
        /// <param name="eye">Where the rays begin, LPS millimetres.</param>
        /// <param name="target">What the middle of the picture shows; not the eye itself.</param>
        /// <param name="up">What is up in the picture; not along the view.</param>
        /// <param name="verticalFovDegrees">Angle from the lower to the upper edge: above 0, below 180.</param>
        /// <param name="width">Pixels, 1 to <see cref="MaxSize"/>.</param>
        /// <param name="height">Pixels, 1 to <see cref="MaxSize"/>.</param>
        /// <exception cref="ArgumentException">An argument lies outside its range.</exception>
        public static PictureRays Perspective(PointMm eye, PointMm target, VectorMm up, double verticalFovDegrees, int width, int height)
        {
            if (!(verticalFovDegrees > 0 && verticalFovDegrees < 180))
                throw new ArgumentOutOfRangeException(nameof(verticalFovDegrees), verticalFovDegrees, "The vertical field of view is above 0 and below 180 degrees.");
            CheckSize(height, nameof(height));
            Axes(eye, target, up, out VectorMm right, out VectorMm upwards, out VectorMm forward);
            double perPixel = 2 * Math.Tan(verticalFovDegrees * (Math.PI / 360)) / height;
            VectorMm dx = perPixel * right;
            VectorMm dy = perPixel * upwards;
            return new PictureRays(
                eye, default, default, forward - width * 0.5 * dx - height * 0.5 * dy, dx, dy, width, height);
        }

        /// <summary>A parallel projection. t is the depth in millimetres from the plane through the eye.</summary>
        /// <param name="eye">The middle of the plane where the rays begin, LPS millimetres.</param>
        /// <param name="target">What the middle of the picture shows; not the eye itself.</param>
        /// <param name="up">What is up in the picture; not along the view.</param>
        /// <param name="heightMm">What the picture shows from its lower to its upper edge, in millimetres: above 0.</param>
        /// <param name="width">Pixels, 1 to <see cref="MaxSize"/>.</param>
        /// <param name="height">Pixels, 1 to <see cref="MaxSize"/>.</param>
        /// <exception cref="ArgumentException">An argument lies outside its range.</exception>
        public static PictureRays Orthographic(PointMm eye, PointMm target, VectorMm up, double heightMm, int width, int height)
        {
            if (!(heightMm > 0) || double.IsInfinity(heightMm))
                throw new ArgumentOutOfRangeException(nameof(heightMm), heightMm, "The height is above 0 mm and finite.");
            CheckSize(height, nameof(height));
            Axes(eye, target, up, out VectorMm right, out VectorMm upwards, out VectorMm forward);
            VectorMm dx = heightMm / height * right;
            VectorMm dy = heightMm / height * upwards;
            return new PictureRays(
                eye - width * 0.5 * dx - height * 0.5 * dy, dx, dy, forward, default, default, width, height);
        }

        /// <summary>The same rays, looked at from <paramref name="nearT"/> to <paramref name="farT"/> only.</summary>
        /// <exception cref="ArgumentException">A number lies outside its range.</exception>
        public PictureRays WithRange(double nearT, double farT) =>
            new PictureRays(Origin, OriginDx, OriginDy, Direction, DirectionDx, DirectionDy, Width, Height, nearT, farT);

        /// <summary>The ray through a place of the picture.</summary>
        /// <param name="x">Pixels from the left edge; a pixel's centre is its column + 0.5.</param>
        /// <param name="y">Pixels from the lower edge; a pixel's centre is its row + 0.5.</param>
        /// <exception cref="ArgumentException">The place has no ray: its direction is zero or not finite.</exception>
        public RayMm Ray(double x, double y) =>
            new RayMm(Origin + (x * OriginDx + y * OriginDy), Direction + x * DirectionDx + y * DirectionDy);

        /// <summary>The ray through a pixel's centre.</summary>
        /// <param name="column">0 = left.</param>
        /// <param name="row">0 = bottom.</param>
        public RayMm RayThroughPixel(int column, int row) => Ray(column + 0.5, row + 0.5);

        static void Axes(PointMm eye, PointMm target, VectorMm up, out VectorMm right, out VectorMm upwards, out VectorMm forward)
        {
            VectorMm towards = target - eye;
            if (!eye.IsFinite || !towards.IsFinite || !(towards.Length > 0))
                throw new ArgumentException(FormattableString.Invariant(
                    $"Eye and target are finite and apart; they are {eye} and {target}."), nameof(target));
            if (!up.IsFinite || !(up.Length > 0))
                throw new ArgumentException(FormattableString.Invariant($"The up direction is finite and not zero; it is {up}."), nameof(up));
            forward = towards / towards.Length;
            VectorMm sideways = forward.Cross(up / up.Length);
            if (!(sideways.Length > SmallestSine))
                throw new ArgumentException(FormattableString.Invariant($"The up direction {up} lies along the view {towards}."), nameof(up));
            right = sideways / sideways.Length;
            upwards = right.Cross(forward);
        }

        static void CheckSize(int pixels, string argument)
        {
            if (pixels < 1 || pixels > MaxSize)
                throw new ArgumentOutOfRangeException(argument, pixels, FormattableString.Invariant($"A picture has 1 to {MaxSize} pixels along each side."));
        }
    }
}
